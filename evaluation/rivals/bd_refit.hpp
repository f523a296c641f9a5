#pragma once

/// The spheres of a BD-tree (bd_records.hpp) for one joint palette, in any order of nodes.
///
/// Rounding. Let u = 2^-24, m the number of terms in the node, n the largest number of influences
/// of a vertex, M the palette's extent and G = sqrt(3) M its reach. Mean weights sum to at most 1,
/// so the sum of the terms never exceeds 6 M. The errors are at most 12 m u M for the 2 m additions
/// of the sum, 32 u M for all of its terms, 4 u M for p_0, 9 u G, times a weight, for each |p_j -
/// p_0|, (n + 4) u G for a posed vertex, and n u G because weights sum to 1 only up to n u. The
/// margin (24 m + 4 n + 48) u G is larger than their sum. The radius is a sum of 2 m + 2 products,
/// all positive; a factor 1 + 2^-22 (m + 4) covers its rounding, in addition to make_ball.

#include "evaluation/rivals/bd_records.hpp"
#include "paper/ball.hpp"
#include "skin/palette.hpp"

namespace pelt::rivals {

using detail::Float4;
using detail::Palette;

/// The constants of a model.
struct BdModel {
  explicit BdModel(const detail::SkinnedMesh& mesh);

  paper::SphereTree tree;
  BdRecords records;
  detail::SkinnedMesh leaf_mesh;  // in the order of the leaves
};

class BdRefit {
 public:
  BdRefit(const BdModel& model, std::uint32_t joint_count);

  /// Call after the palette has changed: marks all spheres as stale.
  void invalidate();

  bool is_stale(std::uint32_t node) const { return node_stamp_[node] != stamp_; }

  /// Precondition: the node is stale.
  void refit(std::uint32_t node, const Palette& palette);

  /// Lanes x, y, z: centre; lane 3: radius. By node. The spheres of stale nodes are meaningless.
  std::span<const Float4> spheres() const { return spheres_; }

  /// Number of refits so far.
  std::uint64_t refits() const { return refits_; }

 private:
  /// A norm that is valid for the palette with the number `stamp`.
  struct Norm {
    float value = 0;
    std::uint32_t stamp = 0;
  };

  float norm_of_joint(std::uint32_t joint, const Palette& palette);
  float norm_of_pair(std::uint32_t pair, const Palette& palette);

  const BdModel* model_;
  std::uint64_t refits_ = 0;
  std::uint32_t stamp_ = 1;
  std::vector<std::uint32_t> node_stamp_;
  std::vector<Float4> spheres_;
  std::vector<Norm> joint_norms_;  // |A_j|
  std::vector<Norm> pair_norms_;   // |A_j - A_0|
};

}  // namespace pelt::rivals

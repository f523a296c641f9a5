#pragma once

/// Kavan & Zara 2005, section 4.2, run-time part: a node's sphere for the current joint palette,
/// computed from the node's rest sphere, joint sets and corners alone, in any order of nodes.
///
/// The paper's joints only rotate. Here a joint may be any affine map C x = A x + t. It maps the
/// rest ball B(c, r) to an ellipsoid inside B(C c, s r), s >= |A|_2, and for every w in W'
///
///     |v' - x| <= max_a ( |R_a - x| + r sum_j r_aj s_j ),     R_a = sum_j r_aj C_j c,
///
/// because the left side, bounded by |sum_j w_j C_j c - x| + r sum_j w_j s_j, is convex in w and
/// therefore largest at a corner. For rotations, s = 1, and this is exactly the paper's refit. (The
/// code maximises the distance and the stretch separately, which is the same if all joints stretch
/// equally, and saves one square root per corner.)
///
/// Rounding. With u = 2^-24, at most n influences, and G the palette's reach, the errors are (n +
/// 4) u G for a posed vertex, (n + 4) u G for a corner's centre, u G for the stored corner weights,
/// and n u G because weights sum to 1 only up to n u. The margin of (4n + 32) u G is larger than
/// their sum; make_ball covers the norms and sums of the last lines.

#include "paper/ball.hpp"
#include "paper/refit_records.hpp"
#include "paper/weight_bounds.hpp"
#include "skin/palette.hpp"

#include <cstdint>
#include <vector>

namespace pelt::paper {

using detail::Palette;

/// An upper bound of |A|_2, the most by which the linear part of a joint matrix stretches; 1 up to
/// rounding for a rotation, at most 4 % too large for any matrix.
float stretch_bound(const Matrix4& joint);

/// The constants of a model.
struct SphereModel {
  SphereTree tree;
  WeightBounds bounds;
  RefitRecords records;   // of both
  SkinnedMesh leaf_mesh;  // in the order of the leaves
};

/// The spheres of one pose. A sphere is refitted on first use and stays valid until the palette
/// changes.
class Refit {
 public:
  explicit Refit(const SphereModel& model, std::uint32_t joint_count);

  /// Call after the palette has changed: marks all spheres as stale. O(1).
  void invalidate();

  bool is_stale(std::uint32_t node) const { return node_stamp_[node] != stamp_; }

  /// Lanes x, y, z: centre; lane 3: radius. The bits do not depend on the order in which spheres
  /// are refitted.
  Float4 sphere(std::uint32_t node, const Palette& palette) {
    if (is_stale(node)) refit(node, palette);
    return spheres_[node];
  }

  /// By node. The spheres of stale nodes are meaningless.
  std::span<const Float4> spheres() const { return spheres_; }

  /// Precondition: the node is stale.
  void refit(std::uint32_t node, const Palette& palette);

  /// Number of refits so far.
  std::uint64_t refits() const { return refits_; }

 private:
  /// R_1 ... R_m of a node.
  struct CornerSpheres {
    std::span<const Float4> spheres;
    Float4 sum;
  };

  /// A joint matrix with the stretch bound in its last row, so that one product gives C_j c and
  /// s_j.
  struct alignas(64) Joint {
    Float4 columns[4];
  };

  void take_palette(const Palette& palette);
  void prefetch_children(const RefitRecord& record) const;
  CornerSpheres blend_corners(RefitRecords::Reader& reader);

  const SphereModel* model_;
  std::vector<Joint> joints_;
  float margin_ = 0;
  std::uint64_t refits_ = 0;
  std::uint32_t stamp_ = 1, palette_stamp_ = 0;
  std::vector<std::uint32_t> node_stamp_;
  std::vector<Float4> spheres_;
  std::vector<Float4> joint_spheres_;   // S_1 ... S_n of the joint set at hand; lane 3: radius / r
  std::vector<Float4> corner_spheres_;  // R_1 ... R_m of the node at hand; lane 3: radius / r
};

}  // namespace pelt::paper

#pragma once

/// James & Pai 2004, "BD-Tree: output-sensitive collision detection for reduced deformable models":
/// where all vertices move by p_i + U_i q, the sphere around some of them moves by the mean of
/// their U_i and grows by the largest deviation from it. Linear blend skinning is such a model: q
/// are the entries of the joint matrices, relative to those of one of them.
///
/// In a node with the rest sphere (c, r), let 0 be the joint with the most weight, y_ij = w_ij
/// (x_i, 1) with x_i = v_i - c, and p_j = C_j c. Then, since the weights of a vertex sum to 1,
///
///     v'_i = p_0 + A_0 x_i + sum_j (A_j - A_0) w_ij x_i + (p_j - p_0) w_ij,
///
/// so that with the means (X_j, W_j) of the y_ij and their largest deviations D^x_j and D^w_j
///
///     centre  p_0 + sum_j (A_j - A_0) X_j + (p_j - p_0) W_j,
///     radius  |A_0| r + sum_j |A_j - A_0| D^x_j + |p_j - p_0| D^w_j.
///
/// Strengthened: x_i starts from the node's centre where the source's U_i start from the origin,
/// which makes the deviations small in small nodes; the base joint is chosen for each node; norms
/// of differences of joint matrices are computed once for each palette and pair of joints that
/// occurs.
///
/// The spheres of a BD-tree for one joint palette, in any order of nodes.
///
/// Rounding. Let u = 2^-24, m the number of terms in the node, n the largest number of influences
/// of a vertex, M the palette's extent and G = sqrt(3) M its reach. Mean weights sum to at most 1,
/// so the sum of the terms never exceeds 6 M. The errors are at most 12 m u M for the 2 m additions
/// of the sum, 32 u M for all of its terms, 4 u M for p_0, 9 u G, times a weight, for each |p_j -
/// p_0|, (n + 4) u G for a posed vertex, and n u G because weights sum to 1 only up to n u. The
/// margin (24 m + 4 n + 48) u G is larger than their sum. The radius is a sum of 2 m + 2 products,
/// all positive; a factor 1 + 2^-22 (m + 4) covers its rounding, in addition to make_ball.
///
/// A BD-tree for each of two bodies: the paper's sphere tree and descent
/// (paper/collide.hpp), but with spheres bounded by means and deviations instead of the
/// corners of the weights. Skins only the vertices of triangles that are tested.

#include "paper/ball.hpp"
#include "paper/collide.hpp"
#include "paper/posed_triangles.hpp"
#include "paper/sphere_tree.hpp"
#include "skin/palette.hpp"

#include <cstdint>
#include <vector>

namespace pelt::rivals {

/// The contribution of a joint other than the base to a node.
struct BdTerm {
  Vec3 mean_x;
  float mean_w = 0;
  float deviation_x = 0, deviation_w = 0;  // rounded up
  std::uint16_t joint = 0;
  std::uint32_t pair = 0;  // of this joint and the base: index into BdRecords::pairs
};

struct BdRecords {
  BdRecords(const detail::SkinnedMesh& mesh, const paper::SphereTree& tree);

  std::vector<std::uint16_t> base;        // by node
  std::vector<std::uint32_t> first_term;  // by node: index into terms; then the end
  std::vector<BdTerm> terms;
  std::vector<std::pair<std::uint16_t, std::uint16_t>> pairs;  // joint and base
  std::uint32_t max_influences = 0;                            // of a vertex
};

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

class BdBody {
 public:
  BdBody(const BdModel& model, std::uint32_t joint_count)
      : model_(model), refit_(model, joint_count), triangles_(model.leaf_mesh) {}

  /// Call after the palette has changed.
  void invalidate() {
    refit_.invalidate();
    triangles_.invalidate();
  }

  /// A body under a palette, as an operand of a descent.
  class Side {
   public:
    Side(BdBody& body, const Palette& palette) : body_(body), palette_(palette) {}

    const paper::SphereTree& tree() const { return body_.model_.tree; }
    void refresh(std::uint32_t first, std::uint32_t end) {
      for (std::uint32_t n = first; n < end; ++n)
        if (body_.refit_.is_stale(n)) body_.refit_.refit(n, palette_);
    }
    const Float4& sphere(std::uint32_t node) const { return body_.refit_.spheres()[node]; }
    const detail::TriangleCorners& corners(const paper::Node& leaf) {
      return body_.triangles_.corners(leaf, palette_);
    }

   private:
    BdBody& body_;
    const Palette& palette_;
  };

  std::uint64_t refits() const { return refit_.refits(); }
  std::uint64_t posed_vertices() const { return triangles_.posed_vertices(); }

 private:
  const BdModel& model_;
  BdRefit refit_;
  paper::PosedTriangles triangles_;
};

/// Appends the contacts of two bodies, in no particular order.
QueryStats collide(BdBody& a, const Palette& palette_a, BdBody& b, const Palette& palette_b,
                   paper::Scratch& scratch, std::vector<Contact>& contacts,
                   std::uint32_t max_contacts);

}  // namespace pelt::rivals

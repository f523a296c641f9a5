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

#include "paper/sphere_tree.hpp"

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

}  // namespace pelt::rivals

#pragma once

/// Kavan & Zara 2005, section 4.2, off-line part: the distinct joint sets of each node of the
/// sphere tree and, for each joint set, the corners of its vertices' weights. With these, a refit
/// of the node needs no vertices.

#include "paper/sphere_tree.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace pelt::paper {

enum class BoundKind {
  optimised,  ///< the generalised convex hull of eq. 4: weight intervals taken into account
  plain,      ///< eq. 2: each joint's sphere whole, whatever the weights
};

/// J_i of a node with its corners r_i1 ... r_im.
struct JointSet {
  std::uint32_t first_joint = 0;   // into WeightBounds::joints
  std::uint32_t first_corner = 0;  // into WeightBounds::corners, joint_count floats each
  std::uint16_t joint_count = 0;
  std::uint16_t corner_count = 0;
};

/// The joint sets of all nodes, stored side by side.
struct WeightBounds {
  std::vector<std::uint32_t> set_begin;  // [nodes + 1], into sets
  std::vector<JointSet> sets;
  std::vector<std::uint16_t> joints;  // each distinct list of joints once
  std::vector<float> corners;
  std::uint32_t max_joints = 0;   // in one set
  std::uint32_t max_corners = 0;  // in all sets of one node

  std::span<const JointSet> sets_of(std::uint32_t node) const {
    return {sets.data() + set_begin[node], set_begin[node + 1] - set_begin[node]};
  }
};

WeightBounds build_weight_bounds(const SkinnedMesh& mesh, const SphereTree& tree, BoundKind kind);

}  // namespace pelt::paper

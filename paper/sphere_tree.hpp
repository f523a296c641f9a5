#pragma once

/// Kavan & Zara 2005, section 3.1: the sphere tree over the rest pose.
///
/// First pass: builds a binary tree top-down, split by Quinlan's heuristic, with the minimal
/// enclosing sphere of the vertices in each node, down to one triangle per leaf. Second pass: if a
/// node's sphere is nearly as large as its parent's, the node is useless, so it is deleted and its
/// children move to the parent.

#include "paper/sphere.hpp"
#include "skin/skinned_mesh.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace pelt::paper {

using detail::SkinnedMesh;

/// The children of a node are contiguous; a leaf has no children and exactly one triangle.
struct Node {
  Sphere rest;
  std::uint32_t first_child = 0, child_count = 0;
  std::uint32_t first_triangle = 0, triangle_count = 0;  // into SphereTree::triangle_order

  bool is_leaf() const { return child_count == 0; }
};

struct SphereTree {
  std::vector<Node> nodes;  // breadth-first: the root first, children after parents
  std::vector<std::uint32_t> triangle_order;  // every node's triangles are contiguous here

  std::span<const std::uint32_t> triangles_of(const Node& node) const {
    return {triangle_order.data() + node.first_triangle, node.triangle_count};
  }
  std::uint32_t triangle_of_leaf(const Node& leaf) const {
    return triangle_order[leaf.first_triangle];
  }
};

/// The first pass. Rest positions are a separate argument, so that a tree can also be built over
/// posed ones.
SphereTree build_binary_tree(std::span<const Vec3> positions, std::span<const Triangle> triangles);

/// The paper's constant C of section 3.1.
inline constexpr float kCollapseRatio = 0.6f;

/// The second pass: an inner node c is deleted if c_r > ratio * p_r, p being the surviving parent.
SphereTree collapse(const SphereTree& binary, float ratio = kCollapseRatio);

/// Both passes.
SphereTree build_sphere_tree(std::span<const Vec3> positions, std::span<const Triangle> triangles,
                             float ratio = kCollapseRatio);

/// The figures of section 5 for one level; the root is level 1.
struct LevelStatistics {
  std::uint32_t nodes = 0, leaves = 0;
  double mean_radius = 0;
  std::uint32_t max_children = 0;
};

/// One entry for each level. `radii` has one radius for each node, at rest or refitted.
std::vector<LevelStatistics> level_statistics(const SphereTree& tree, std::span<const float> radii);
std::vector<LevelStatistics> level_statistics(const SphereTree& tree);

}  // namespace pelt::paper

#pragma once

/// A binary tree of axis-aligned boxes, built from the top down by the surface area heuristic
/// (Goldsmith & Salmon 1987) over bins (Wald 2007, "On fast construction of SAH-based bounding
/// volume hierarchies").

#include "evaluation/rivals/box.hpp"

#include <vector>

namespace pelt::rivals {

/// A node. Of a leaf, the triangles [first, first + count) in the tree's order; otherwise count is
/// 0 and the children are first and first + 1.
using BoxNode = NumberedBox;

inline constexpr std::uint32_t kMostLeafTriangles = 32;

/// Breadth first: the root is node 0, children come after their parents and side by side.
struct BoxTree {
  std::vector<BoxNode> nodes;
  std::vector<std::uint32_t> order;  // [T] triangles, those of a leaf side by side
};

/// Leaves have at most `leaf_triangles`. O(T log T) unless the boxes are made to prevent it.
/// Precondition: there is at least one triangle, and 1 <= leaf_triangles <= kMostLeafTriangles.
BoxTree build_box_tree(std::span<const Triangle> triangles, const Points& points,
                       std::uint32_t leaf_triangles);

}  // namespace pelt::rivals

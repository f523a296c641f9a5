#pragma once

/// A binary tree of axis-aligned boxes, built top-down by the surface area heuristic (Goldsmith &
/// Salmon 1987) over bins (Wald 2007, "On fast construction of SAH-based bounding volume
/// hierarchies").

#include "evaluation/rivals/box.hpp"

#include <vector>

namespace pelt::rivals {

/// A node. A leaf has the triangles [first, first + count) in the tree's order. For an inner node,
/// count is 0 and the children are first and first + 1.
using BoxNode = NumberedBox;

inline constexpr std::uint32_t kMaxLeafTriangles = 32;

/// Breadth-first: the root is node 0, children follow their parents, and siblings are adjacent.
struct BoxTree {
  std::vector<BoxNode> nodes;
  std::vector<std::uint32_t> order;  // [T] triangles; those of a leaf are contiguous
};

/// Builds a tree whose leaves have at most `leaf_triangles`. O(T log T), except for boxes that are
/// made to prevent it. Precondition: there is at least one triangle, and 1 <= leaf_triangles <=
/// kMaxLeafTriangles.
BoxTree build_box_tree(std::span<const Triangle> triangles, const Points& points,
                       std::uint32_t leaf_triangles);

}  // namespace pelt::rivals

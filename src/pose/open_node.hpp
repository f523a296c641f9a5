#pragma once

#include <pelt/collide.hpp>

#include "base/target.hpp"
#include "geometry/box4.hpp"
#include "pose/posed_tree.hpp"

#include <span>

namespace pelt::detail {
inline namespace PELT_TARGET {

/// The box around all vertices, computed if it was not; counts the work in `work`.
const RootBox& root_box(const PosedTree& posed, QueryStats& work);

/// Opens a node, unless another thread has done it meanwhile.
const OpenedNode& open_closed_node(const PosedTree& posed, std::uint32_t node, QueryStats& work);

/// The node, opened if it was not; counts the work in `work`.
inline const OpenedNode& open_node(const PosedTree& posed, std::uint32_t node, QueryStats& work) {
  const OpenedNode* known = posed.opened[node];
  return known ? *known : open_closed_node(posed, node, work);
}

/// Computes the boxes of a cluster's triangles.
const TriangleBoxes& box_triangles(const PosedTree& posed, const Node& node,
                                   const OpenedNode& opened, std::uint32_t slot);

/// The boxes of a cluster's triangles. Precondition: `opened` is the opened `node`.
inline const TriangleBoxes& triangle_boxes(const PosedTree& posed, const Node& node,
                                           const OpenedNode& opened, std::uint32_t slot) {
  const TriangleBoxes* known = opened.triangles[slot].load(std::memory_order_acquire);
  return known ? *known : box_triangles(posed, node, opened, slot);
}

/// Opens every node that is not open yet, bottom-up, with the boxes of what is below: a fraction of
/// the cost of opening all on demand. Precondition: there is a table of opened nodes.
QueryStats open_rest(const PosedTree& posed);

/// Opens every node bottom-up, so that every box, that of the root included, is the exact one of
/// the posed vertices below: what an engine without refit on demand does. Precondition: there is a
/// table of opened nodes, and none is open.
QueryStats open_all_exactly(const PosedTree& posed);

/// Poses all vertices, in the caller's order.
void pose_vertices(const Tree& tree, const Palette& palette, std::span<Vec3> out);

/// The box of the posed vertices at these places of the pools.
Box4 box_vertices(const Tree& tree, const Palette& palette, std::span<const std::uint32_t> at);

}  // namespace PELT_TARGET
}  // namespace pelt::detail

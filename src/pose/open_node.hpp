#pragma once

/// Opens nodes: poses their vertices, and computes the boxes of their slots.

#include <pelt/query.hpp>

#include "base/instruction_set.hpp"
#include "geometry/box4.hpp"
#include "pose/posed_tree.hpp"

#include <span>

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {

/// Returns the box of all vertices. Computes it first if necessary, and counts that in `work`.
const RootBox& root_box(const PosedTree& posed, QueryStats& work);

/// Opens a node, unless another thread opens it first.
const OpenedNode& open_closed_node(const PosedTree& posed, std::uint32_t node, QueryStats& work);

/// Returns the opened node. Opens it first if necessary, and counts that in `work`.
inline const OpenedNode& open_node(const PosedTree& posed, std::uint32_t node, QueryStats& work) {
  const OpenedNode* known = posed.opened[node];
  return known ? *known : open_closed_node(posed, node, work);
}

/// Computes the boxes of a cluster's triangles from its node's posed pool.
void compute_triangle_boxes(const Tree& tree, const Cluster& cluster, const float* positions,
                            TriangleBoxes& boxes);

/// Computes the boxes of a cluster's triangles, and keeps them in the opened node.
const TriangleBoxes& box_triangles(const PosedTree& posed, const Node& node,
                                   const OpenedNode& opened, std::uint32_t slot);

/// Returns the boxes of a cluster's triangles. Precondition: `opened` is the opened `node`.
inline const TriangleBoxes& triangle_boxes(const PosedTree& posed, const Node& node,
                                           const OpenedNode& opened, std::uint32_t slot) {
  const TriangleBoxes* known = opened.triangles[slot].load(std::memory_order_acquire);
  return known ? *known : box_triangles(posed, node, opened, slot);
}

/// Opens every closed node bottom-up, with the boxes of its children as slot boxes. Costs a
/// fraction of opening all nodes on demand. If no node is open and the root box is not known, every
/// box, including that of the root, becomes the exact box of the posed vertices below, as in an
/// engine without refitting on demand. Precondition: the table of opened nodes exists.
QueryStats open_all(const PosedTree& posed);

/// Poses all vertices in the caller's order.
void pose_vertices(const Tree& tree, const Palette& palette, std::span<Vec3> out);

/// Returns the box of the posed vertices at these positions in the pools. Adds the displacements by
/// morph targets to `displacements`.
Box4 box_vertices(const Tree& tree, const Palette& palette, std::span<const std::uint32_t> at,
                  std::uint64_t& displacements);

/// Computes every bound that a query could need: the root box, all nodes, and the boxes of all
/// triangles. Returns the work. Precondition: the table of opened nodes exists.
QueryStats compute_all_bounds(const PosedTree& posed);

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail

#pragma once

/// View of one instance for queries. Queries change an instance only by opening nodes, which poses
/// the node's vertices, computes exact boxes of its clusters from them, and computes the boxes of
/// its children from the joint palette. Doing this only when needed is the refit on demand of Kavan
/// & Zara (2005, section 4.2). If the caller has given all vertices, opening copies nothing, and
/// the boxes of children are known.

#include "model/node_bounds.hpp"
#include "model/tree.hpp"
#include "pose/given_vertices.hpp"
#include "pose/opened_node.hpp"
#include "pose/pose_boxes.hpp"
#include "skin/palette.hpp"

#include <cstddef>

namespace pelt::detail {

struct PosedTree {
  const Tree& tree;
  const NodeBounds& bounds;
  const Palette& palette;
  const GivenVertices& given;  ///< if any, the palette has no meaning
  RootBox& root_box;           ///< unlike nodes, must not be used by two threads at once
  OpenedNodes& opened;
  Arena& arena;  ///< memory for the nodes that this thread opens
};

/// Creates the table of opened nodes if necessary. Instances that are far from all others never
/// need it. Must not be called by two threads at once.
void make_table(const PosedTree& posed);

/// Bytes of arena memory for the table and all nodes, if one thread opens everything.
std::size_t bytes_to_open(const Tree& tree);

}  // namespace pelt::detail

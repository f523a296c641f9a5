#pragma once

/// One instance as queries see it, and the one thing that they do to it: open a node. That poses
/// the node's vertices, takes the exact boxes of its clusters from them and the bounds of its child
/// nodes from the joint palette. That it waits until then is Kavan & Zara's refit on demand (2005,
/// section 4.2).

#include "model/node_bounds.hpp"
#include "model/tree.hpp"
#include "pose/opened_node.hpp"
#include "pose/root_box.hpp"
#include "skin/palette.hpp"

#include <cstddef>

namespace pelt::detail {

struct PosedTree {
  const Tree& tree;
  const NodeBounds& bounds;
  const Palette& palette;
  RootBox& root_box;  ///< not to be asked for by two threads at once, unlike the nodes
  OpenedNodes& opened;
  Arena& arena;  ///< where this thread's opened nodes lie
};

/// Makes the table of opened nodes if there is none yet, which instances that are far from all
/// others never need. Not by two threads at once.
void make_table(const PosedTree& posed);

/// What the table and everything that can be opened take of one thread's arena.
std::size_t bytes_to_open(const Tree& tree);

}  // namespace pelt::detail

#pragma once

/// The start of a descent of two posed trees.

#include "pose/open_node.hpp"
#include "query/pair_descent.hpp"

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {

/// Returns whether the root boxes overlap. If so, makes the tables of opened nodes.
inline bool begin_descent(const PosedTree& a, const PosedTree& b, QueryStats& work) {
  ++work.node_pairs;
  const RootBox &root_a = root_box(a, work), &root_b = root_box(b, work);
  if (!boxes_overlap(root_a.low, root_a.high, root_b.low, root_b.high)) return false;
  make_table(a);
  make_table(b);
  return true;
}

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail

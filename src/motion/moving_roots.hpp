#pragma once

/// The start of a descent of two moving trees.

#include "motion/moving_boxes.hpp"
#include "motion/moving_tree.hpp"
#include "pose/pose_boxes.hpp"

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {

/// Returns whether the root boxes may overlap at some time. If so, makes the tables of opened
/// nodes.
inline bool begin_descent(const MovingTree& a, const MovingTree& b, QueryStats& work) {
  ++work.node_pairs;
  const auto boxes = [&](const PosedTree& posed) {
    const RootBox& box = root_box(posed, work);
    return repeat(point_box(box.low, box.high));
  };
  TimeRanges8 times(1);
  if (!may_overlap({boxes(a.from), boxes(a.to)}, {boxes(b.from), boxes(b.to)}, times)) return false;
  for (const PosedTree* posed : {&a.from, &a.to, &b.from, &b.to}) make_table(*posed);
  return true;
}

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail

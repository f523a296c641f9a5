#pragma once

/// The start of a descent of two moving trees.

#include "motion/moving_boxes.hpp"
#include "motion/moving_tree.hpp"
#include "pose/root_box.hpp"
#include "query/pair_descent.hpp"
#include "query/scratch.hpp"

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {

/// Whether the root boxes may overlap at some time.
inline bool roots_overlap(const MovingTree& a, const MovingTree& b, QueryStats& work) {
  ++work.node_pairs;
  const auto boxes = [&](const PosedTree& posed) {
    const RootBox& box = root_box(posed, work);
    return repeat(point_box(box.low, box.high));
  };
  TimeRanges8 times(1);
  return may_overlap({boxes(a.from), boxes(a.to)}, {boxes(b.from), boxes(b.to)}, times) != 0;
}

/// Returns whether the descent ended early.
template <typename Rule>
bool descend_from_roots(const MovingTree& a, const MovingTree& b, Scratch& scratch, Rule& rule,
                        QueryStats& work) {
  for (const PosedTree* posed : {&a.from, &a.to, &b.from, &b.to}) make_table(*posed);
  scratch.slot_pairs.clear();
  scratch.slot_pairs.push({0, kAllSlots, 0, kAllSlots});
  PairDescent descent(a, b, scratch.slot_pairs, rule, work);
  descent.run();
  return descent.is_unfinished();
}

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail

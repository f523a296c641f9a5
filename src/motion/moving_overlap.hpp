#pragma once

/// Pruning by boxes of both ends of a step, for PairDescent (query/pair_descent.hpp).

#include "motion/moving_boxes.hpp"
#include "motion/moving_tree.hpp"
#include "query/pair_descent.hpp"

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {

/// The part of a Rule that decides which nodes and slots are near: those whose boxes may overlap at
/// some time until `latest`.
class MovingOverlap {
 public:
  explicit MovingOverlap(float latest = 1) : latest_(latest) {}

  float latest() const { return latest_; }

  /// Only whether the boxes are on one side of each other at both ends.
  static bool overlaps(const MovingNode& a, const MovingNode& b) {
    const Mask4 below = beside(a.from, b.from) & beside(a.to, b.to);
    const Mask4 above = beside(b.from, a.from) & beside(b.to, a.to);
    return ((below.bits() | above.bits()) & 7) == 0;
  }

  unsigned slots_near(const MovingNode& of, const MovingNode& all) const {
    TimeRanges8 times(latest_);
    return slots_in(of, box_of(all), times);
  }

  unsigned slots_near(const MovingNode& of, const MovingNode& other, unsigned slot) const {
    TimeRanges8 times(latest_);
    return slots_in(of, box_of(other, slot), times);
  }

  static float depth(const MovingNode& a, unsigned slot, const MovingNode& b) {
    const float from = BoxOverlap::depth(a.from, slot, b.from);
    const float to = BoxOverlap::depth(a.to, slot, b.to);
    return from < to ? to : from;
  }

 protected:
  void set_latest(float latest) { latest_ = latest; }

  static MovingBoxes8 box_of(const MovingNode& node) {
    return {repeat(point_box(node.from.all_low, node.from.all_high)),
            repeat(point_box(node.to.all_low, node.to.all_high))};
  }

  static MovingBoxes8 box_of(const MovingNode& node, unsigned slot) {
    return {repeat(lane_box(node.from.low, node.from.high, slot)),
            repeat(lane_box(node.to.low, node.to.high, slot))};
  }

  static unsigned slots_in(const MovingNode& node, const MovingBoxes8& box, TimeRanges8& times) {
    return may_overlap(
        {load_boxes(node.from.low, node.from.high, 0), load_boxes(node.to.low, node.to.high, 0)},
        box, times);
  }

 private:
  static Mask4 beside(const OpenedNode& low, const OpenedNode& high) {
    return load4(low.all_high) < load4(high.all_low);
  }

  float latest_;
};

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail

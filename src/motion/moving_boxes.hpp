#pragma once

/// Boxes in motion. Vertices move in straight lines, at constant speed, between positions in a box
/// `from` at time 0 and positions in a box `to` at time 1. At time t, they are inside the box
/// (1 - t) from + t to, because each bound is a bound of both ends.
///
/// On one axis, two such boxes are apart at time t if a gap is positive: the lower bound of one
/// less the upper bound of the other. Gaps are linear in t. If one is positive at both ends, the
/// boxes never overlap. If it is positive at one end only, it is 0 at t = g0 / (g0 - g1), and the
/// boxes overlap on one side of this time at most.
///
/// Rounding. The sign of a float difference is exact. g0 and g1 have different signs, so the
/// quotient has at most four relative errors of 2^-24; the factors 1 -+ 2^-21 cover them and their
/// own, and 2^-100 covers underflow.

#include "motion/moving_tree.hpp"
#include "motion/moving_triage.hpp"
#include "pose/pose_boxes.hpp"
#include "query/pair_descent.hpp"
#include "query/slots.hpp"

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {

struct MovingBoxes8 {
  Boxes8 from, to;
};

inline TimeSpans8 times_between(float earliest, float latest) {
  return {Float8(earliest), Float8(latest)};
}

/// Removes times at which a gap is certainly positive. Precondition: in lanes that matter, it is
/// not positive at both ends.
[[gnu::always_inline]] inline void clip(TimeSpans8& times, const Float8& gap_at_0,
                                        const Float8& gap_at_1) {
  const Float8 zero(0.0f), time = gap_at_0 / (gap_at_0 - gap_at_1);
  const Float8 early = time * Float8(1 - 0x1p-21f) - Float8(0x1p-100f);
  const Float8 late = time * Float8(1 + 0x1p-21f) + Float8(0x1p-100f);
  times.start = select(zero < gap_at_0, max(times.start, early), times.start);
  times.end = select(zero < gap_at_1, min(times.end, late), times.end);
}

/// Returns which boxes may overlap at some time, one bit per lane. Removes other times from
/// `times`.
[[gnu::always_inline]] inline unsigned may_overlap(const MovingBoxes8& a, const MovingBoxes8& b,
                                                   TimeSpans8& times) {
  const auto beside = [](const Boxes8& low, const Boxes8& high, int axis) {
    return high.high[axis] < low.low[axis];
  };
  Mask8 apart = Float8(1.0f) < Float8(0.0f);
  for (int axis = 0; axis < 3; ++axis)
    apart = apart | (beside(a.from, b.from, axis) & beside(a.to, b.to, axis)) |
            (beside(b.from, a.from, axis) & beside(b.to, a.to, axis));
  const unsigned near = ~apart.bits() & 0xFF;
  if (near == 0) return 0;
  for (int axis = 0; axis < 3; ++axis) {
    clip(times, a.from.low[axis] - b.from.high[axis], a.to.low[axis] - b.to.high[axis]);
    clip(times, b.from.low[axis] - a.from.high[axis], b.to.low[axis] - a.to.high[axis]);
  }
  return near & times.not_empty();
}

/// Whether boxes may overlap at some time until `latest`, as an argument of
/// WaitingMovingPairs::add.
struct OverlapUntil {
  float latest = 1;

  [[gnu::always_inline]] unsigned operator()(const MovingBoxes8& a, const MovingBoxes8& b) const {
    TimeSpans8 times = times_between(0, latest);
    return may_overlap(a, b, times);
  }
};

/// The part of a Rule of PairDescent (query/pair_descent.hpp) that decides which nodes and slots
/// are near: those whose boxes may overlap at some time until `latest`.
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
    TimeSpans8 times = times_between(0, latest_);
    return slots_in(of, box_of(all), times);
  }

  unsigned slots_near(const MovingNode& of, const MovingNode& other, unsigned slot) const {
    TimeSpans8 times = times_between(0, latest_);
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

  [[gnu::always_inline]] static unsigned slots_in(const MovingNode& node, const MovingBoxes8& box,
                                                  TimeSpans8& times) {
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

/// Starts a descent of two moving trees. Returns whether the root boxes may overlap at some time.
/// If so, makes the tables of opened nodes.
inline bool begin_descent(const MovingTree& a, const MovingTree& b, QueryStats& work) {
  ++work.node_pairs;
  const auto boxes = [&](const PosedTree& posed) {
    const RootBox& box = root_box(posed, work);
    return repeat(point_box(box.low, box.high));
  };
  TimeSpans8 times = times_between(0, 1);
  if (!may_overlap({boxes(a.from), boxes(a.to)}, {boxes(b.from), boxes(b.to)}, times)) return false;
  make_table(a);
  make_table(b);
  return true;
}

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail

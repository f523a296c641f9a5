/// Descent of two moving trees for triangles that intersect at some time of a step. Nodes are
/// tested by their boxes at both ends (moving_boxes.hpp), so common motion cancels.

#include "collide/collide_trees.hpp"

#include "motion/meeting_order.hpp"
#include "motion/moving_boxes.hpp"
#include "motion/moving_pairs.hpp"
#include "query/contact_sink.hpp"
#include "query/pair_descent.hpp"

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {
namespace {

/// Tests the triangles of overlapping clusters until there are enough contacts.
class IntersectingWhileMoving : public MovingOverlap {
 public:
  IntersectingWhileMoving(const Tree& a, const Tree& b, const LimitedSink<MovingContact>& sink,
                          const MovingOptions& options, MovingStats& work)
      : sink_(sink), pairs_(a, b), triangles_(pairs_, sink, options, work) {}

  bool is_full() const { return sink_.is_full(); }
  bool is_impatient() const { return sink_.is_impatient(); }

  void test(const MovingCluster& a, const MovingCluster& b) {
    pairs_.add(a, b, OverlapUntil{latest()}, [this] { flush(); });
    if (is_impatient()) flush();
  }

  void flush() { triangles_.flush(); }

 private:
  const LimitedSink<MovingContact>& sink_;
  WaitingMovingPairs pairs_;
  MovingTrianglePairs<WaitingMovingPairs, const LimitedSink<MovingContact>> triangles_;
};

}  // namespace

MovingStats collide_moving_trees(const MovingTree& a, const MovingTree& b, Scratch& scratch,
                                 const MovingOptions& options) {
  MovingStats work;
  scratch.moving.clear();
  if (!begin_descent(a, b, work)) return work;
  const LimitedSink sink(scratch.moving, options.max_contacts);
  IntersectingWhileMoving rule(a.tree, b.tree, sink, options, work);
  const bool is_unfinished = descend_from_roots(a, b, scratch.slot_pairs, rule, work);
  rule.flush();
  work.cut_short = sink.cut(is_unfinished);
  return work;
}

namespace {

/// Finds the pair of triangles that intersects first, among the pairs that are apart at time 0.
/// Once a pair is known, skips boxes that overlap only after its time. Visits the nodes whose boxes
/// overlap earliest first, to find an early pair soon.
class FirstWhileMoving : public MovingOverlap {
 public:
  FirstWhileMoving(const Tree& a, const Tree& b, EarliestPair& earliest, MovingStats& work)
      : pairs_(a, b), earliest_(earliest), work_(work) {}

  static bool is_full() { return false; }
  static bool is_impatient() { return true; }

  /// Boxes that overlap at time 0 by their depth, and before all others by the negative time.
  float depth(const MovingNode& a, unsigned slot, const MovingNode& b) const {
    TimeSpans8 times = times_between(0, latest());
    slots_in(a, box_of(b), times);
    const float start = lane_of(times.start, slot);
    return start > 0 ? -start : BoxOverlap::depth(a.from, slot, b.from);
  }

  void test(const MovingCluster& a, const MovingCluster& b) {
    pairs_.add(a, b, OverlapUntil{latest()}, [this] { flush(); });
    flush();
  }

 private:
  void flush() {
    const unsigned kept = (1u << pairs_.count()) - 1;
    if (kept == 0) return;
    const MovingPairs8 corners = pairs_.corners8();
    const LanesUntil lanes(corners, kept & ~triage(corners.from).intersecting, latest());
    for (SetBits pair(lanes.left()); pair; ++pair)
      if (lanes.start(*pair) <= latest()) decide(*pair);
    work_.triangle_pairs += pairs_.count();
    pairs_.clear();
  }

  void decide(unsigned pair) {
    earliest_.add(pairs_.contact(pair), pairs_.triangle_a(pair), pairs_.triangle_b(pair), work_);
    set_latest(earliest_.latest());
  }

  WaitingMovingPairs pairs_;
  EarliestPair& earliest_;
  MovingStats& work_;
};

}  // namespace

MovingStats first_contact_of_trees(const MovingTree& a, const MovingTree& b, Scratch& scratch,
                                   std::optional<MovingContact>& first) {
  MovingStats work;
  first.reset();
  if (!begin_descent(a, b, work)) return work;
  EarliestPair earliest;
  FirstWhileMoving rule(a.tree, b.tree, earliest, work);
  descend_from_roots(a, b, scratch.slot_pairs, rule, work);
  first = earliest.contact();
  return work;
}

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail

/// Steps of a search for the first contact. Each step replaces one open item by items for parts of
/// the same triangles, or tests the triangles of two clusters: the item of the earliest start or,
/// beyond `max_open`, the item that was added last. An item starts no earlier than the item that it
/// replaces, so the earliest start of all items never falls.
///
/// Once triangles are known to intersect at time 0, only the `from` poses matter: both motions are
/// replaced by motions that stand still.
///
/// Items are replaced as in query/pair_descent.hpp, which says why there are three such functions.
/// This one computes the times of each new item.

#include "collide/first_contact_search.hpp"

#include "motion/moving_boxes.hpp"
#include "motion/moving_filter.hpp"
#include "motion/moving_pairs.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {
namespace {

/// Times outside which two things do not touch.
struct TimeSpan {
  float start = HUGE_VALF, end = 0;

  void unite(const TimeSpan& other) {
    start = std::min(start, other.start);
    end = std::max(end, other.end);
  }
};

/// The times of each lane.
struct TimeSpanLanes {
  explicit TimeSpanLanes(const TimeSpans8& times) {
    times.start.store(start);
    times.end.store(end);
  }

  TimeSpan operator[](unsigned lane) const { return {start[lane], end[lane]}; }

  TimeSpan of_all(unsigned lanes) const {
    TimeSpan all;
    for (SetBits lane(lanes); lane; ++lane) all.unite((*this)[*lane]);
    return all;
  }

  float start[8], end[8];
};

/// Whether boxes may overlap at some time of a span, as an argument of WaitingMovingPairs::add.
struct OverlapWithin {
  TimeSpan span;

  [[gnu::always_inline]] unsigned operator()(const MovingBoxes8& a, const MovingBoxes8& b) const {
    TimeSpans8 times = times_between(span.start, span.end);
    return may_overlap(a, b, times);
  }
};

/// The same for time 0.
struct OverlapAtStart {
  unsigned operator()(const MovingBoxes8& a, const MovingBoxes8& b) const {
    Mask8 overlap = Float8(0.0f) <= Float8(0.0f);
    for (int axis = 0; axis < 3; ++axis)
      overlap = overlap & (a.from.low[axis] <= b.from.high[axis]) &
                (b.from.low[axis] <= a.from.high[axis]);
    return overlap.bits();
  }
};

/// One side of the search.
struct MovingSide {
  MovingTree moving, still;
  NeededNodes& needed;
};

class FirstContactSteps : MovingOverlap {
 public:
  FirstContactSteps(const MovingTree& a, const MovingTree& b, FirstContactState& state)
      : MovingOverlap(state.latest()),
        a_{a, {a.from, a.from}, state.needed_a},
        b_{b, {b.from, b.from}, state.needed_b},
        state_(state),
        pairs_(a.tree, b.tree),
        base_(state.work.done) {}

  MovingStats run() {
    while (!state_.open.is_empty() && state_.work.is_left()) {
      step(state_.open.pop());
      state_.open.drop_after(latest());
      state_.work.end_step(base_ + kDoublePairWork * work_.double_pairs +
                           kExactPairWork * work_.exact_pairs);
    }
    if (state_.at_start) flush_at_start();
    return work_;
  }

 private:
  void step(const TimedItem& item) {
    if (item.step == ItemStep::compare) return compare(item);
    if (item.step == ItemStep::replace_b) return replace_b(item);
    test(item);
  }

  const MovingTree& view(const MovingSide& side) const {
    return state_.at_start ? side.still : side.moving;
  }

  MovingNode open(const MovingSide& side, std::uint32_t index) {
    const MovingTree& tree = view(side);
    base_ += work_to_need(tree.from, index, side.needed.from);
    const bool is_one_pose = &tree.to.opened == &tree.from.opened;
    if (!is_one_pose) base_ += work_to_need(tree.to, index, side.needed.to);
    return open_node(tree, index, work_);
  }

  TimeSpans8 times_of(const TimeSpan& span) const {
    return times_between(span.start, std::min(span.end, latest()));
  }

  void add(ItemStep step, std::uint32_t node_a, unsigned slots_a, std::uint32_t node_b,
           unsigned slots_b, const TimeSpan& span, float depth) {
    new_[count_++] = {span.start,
                      span.end,
                      depth,
                      node_a,
                      node_b,
                      static_cast<std::uint8_t>(slots_a),
                      static_cast<std::uint8_t>(slots_b),
                      step,
                      0};
  }

  /// Compares the slots of two nodes.
  void compare(const TimedItem& item) {
    ++work_.node_pairs;
    base_ += kMovingNodePairWork;
    const MovingNode a = open(a_, item.node_a), b = open(b_, item.node_b);
    const Node& node_a = a_.moving.tree.nodes[item.node_a];
    TimeSpans8 times = times_of({item.start, item.end});
    const unsigned near_a = item.slots_a & slots_in(a, box_of(b), times);
    const TimeSpanLanes spans(times);
    SpansOfChildB spans_of_child_b;
    count_ = 0;
    for (SetBits slot(near_a); slot; ++slot) {
      TimeSpans8 times_b = times_of(spans[*slot]);
      const unsigned near_b = item.slots_b & slots_in(b, box_of(a, *slot), times_b);
      if (near_b == 0) continue;
      const TimeSpanLanes spans_b(times_b);
      const float depth = BoxOverlap::depth(a.from, *slot, b.from);
      if (*slot < node_a.cluster_count) {
        compare_cluster(item, *slot, near_b, spans_b, depth, spans_of_child_b);
      } else {
        add(ItemStep::replace_b, child(node_a, *slot), kAllSlots, item.node_b, near_b,
            spans_b.of_all(near_b), depth);
      }
    }
    add_children_of_b(item, a, b, spans_of_child_b);
    push_new();
  }

  /// For each child of b's node, the clusters of a's node that may overlap it, and when.
  struct SpansOfChildB {
    unsigned slots_a[kMaxSlots] = {};
    TimeSpan spans[kMaxSlots];
  };

  /// Adds one cluster of a with each of the clusters of b that are near.
  void compare_cluster(const TimedItem& item, unsigned slot, unsigned near_b,
                       const TimeSpanLanes& spans, float depth, SpansOfChildB& children) {
    const unsigned clusters = clusters_of(b_.moving.tree.nodes[item.node_b]);
    for (SetBits other(near_b & clusters); other; ++other)
      add(ItemStep::test, item.node_a, 1u << slot, item.node_b, 1u << *other, spans[*other], depth);
    for (SetBits other(near_b & ~clusters); other; ++other) {
      children.slots_a[*other] |= 1u << slot;
      children.spans[*other].unite(spans[*other]);
    }
  }

  void add_children_of_b(const TimedItem& item, const MovingNode& a, const MovingNode& b,
                         const SpansOfChildB& children) {
    const Node& node_b = b_.moving.tree.nodes[item.node_b];
    for (std::uint32_t slot = node_b.cluster_count; slot < kMaxSlots; ++slot)
      if (const unsigned slots_a = children.slots_a[slot])
        add(ItemStep::compare, item.node_a, slots_a, child(node_b, slot), kAllSlots,
            children.spans[slot], BoxOverlap::depth(b.from, slot, a.from));
  }

  /// Replaces b's node by its slots. After a's child was opened, fewer may overlap.
  void replace_b(const TimedItem& item) {
    base_ += kMovingNodePairWork / 2;
    const MovingNode a = open(a_, item.node_a), b = open(b_, item.node_b);
    const Node& node_b = b_.moving.tree.nodes[item.node_b];
    TimeSpans8 times = times_of({item.start, item.end});
    const unsigned slots_b = item.slots_b & slots_in(b, box_of(a), times);
    const TimeSpanLanes spans(times);
    count_ = 0;
    if (const unsigned clusters = slots_b & clusters_of(node_b))
      add(ItemStep::compare, item.node_a, kAllSlots, item.node_b, clusters, spans.of_all(clusters),
          item.depth);
    for (SetBits slot(slots_b & ~clusters_of(node_b)); slot; ++slot) {
      TimeSpans8 times_a = times_of(spans[*slot]);
      const unsigned slots_a = slots_in(a, box_of(b, *slot), times_a);
      if (slots_a != 0)
        add(ItemStep::compare, item.node_a, slots_a, child(node_b, *slot), kAllSlots,
            TimeSpanLanes(times_a).of_all(slots_a), BoxOverlap::depth(b.from, *slot, a.from));
    }
    push_new();
  }

  /// Pushes the items that a step has added, the most promising last.
  void push_new() {
    const bool is_full = state_.open.size() + count_ > state_.max_open;
    for (std::uint32_t i = 1; i < count_; ++i) {
      const TimedItem moved = new_[i];
      std::uint32_t place = i;
      for (; place > 0 && is_sooner(new_[place - 1], moved); --place) new_[place] = new_[place - 1];
      new_[place] = moved;
    }
    for (std::uint32_t i = 0; i < count_; ++i)
      if (is_full) {
        state_.open.push_depth_first(new_[i]);
      } else {
        state_.open.push(new_[i]);
      }
  }

  static bool is_sooner(const TimedItem& item, const TimedItem& other) {
    return item.start != other.start ? item.start < other.start : item.depth > other.depth;
  }

  /// Tests the triangles of two clusters.
  void test(const TimedItem& item) {
    const MovingCluster a = cluster_of(a_, item.node_a, item.slots_a);
    const MovingCluster b = cluster_of(b_, item.node_b, item.slots_b);
    base_ += kMovingClusterPairWork;
    if (state_.at_start) return test_at_start(a, b);
    item_span_ = {item.start, std::min(item.end, latest())};
    pairs_.add(a, b, OverlapWithin{item_span_}, [this] { flush(); });
    flush();
  }

  /// Pairs of triangles may wait for the next step, because they do not change which items are
  /// open. They count already, so that the size of slices makes no difference.
  void test_at_start(const MovingCluster& a, const MovingCluster& b) {
    const std::uint64_t before = work_.triangle_pairs + pairs_.count();
    pairs_.add(a, b, OverlapAtStart{}, [this] { flush_at_start(); });
    base_ += kTrianglePairWork * (work_.triangle_pairs + pairs_.count() - before);
  }

  MovingCluster cluster_of(const MovingSide& side, std::uint32_t index, unsigned slots) const {
    const MovingTree& tree = view(side);
    return {tree,
            tree.tree.nodes[index],
            {*tree.from.opened[index], *tree.to.opened[index]},
            static_cast<std::uint32_t>(std::countr_zero(slots))};
  }

  void flush() {
    const unsigned kept = lanes_in_use();
    if (kept == 0) return;
    base_ += kMovingTrianglePairWork * pairs_.count();
    const MovingPairs8 corners = pairs_.corners8();
    const Triage verdict = triage(corners.from);
    if (!state_.leave_out_start) note_at_start(kept, verdict);
    if (!state_.at_start) decide_moving(kept & ~verdict.intersecting, corners);
    clear_pairs();
  }

  void flush_at_start() {
    const unsigned kept = lanes_in_use();
    if (kept == 0) return;
    note_at_start(kept, triage(pairs_.corners_at_start8()));
    clear_pairs();
  }

  unsigned lanes_in_use() const { return (1u << pairs_.count()) - 1; }

  void clear_pairs() {
    work_.triangle_pairs += pairs_.count();
    pairs_.clear();
  }

  /// Notes the pairs that intersect at time 0. If there are any, the pairs that `verdict` leaves
  /// undecided are decided exactly.
  void note_at_start(unsigned kept, const Triage& verdict) {
    unsigned intersecting = kept & verdict.intersecting;
    if (state_.at_start || intersecting != 0)
      intersecting |= decide_exactly(
          verdict, kept, [this](unsigned lane) { return pairs_.triangle_a(lane).from; },
          [this](unsigned lane) { return pairs_.triangle_b(lane).from; });
    for (SetBits lane(intersecting); lane; ++lane) note_at_start(pairs_.contact(*lane));
  }

  void note_at_start(const Contact& contact) {
    state_.at_start = state_.at_start ? std::min(*state_.at_start, contact) : contact;
    set_latest(0);
  }

  void decide_moving(unsigned kept, const MovingPairs8& corners) {
    const LanesUntil lanes(corners, kept, std::min(item_span_.end, latest()));
    for (SetBits lane(lanes.left()); lane; ++lane)
      if (lanes.start(*lane) <= latest()) decide(*lane);
  }

  void decide(unsigned lane) {
    const Contact contact = pairs_.contact(lane);
    const MovingTriangle a = pairs_.triangle_a(lane), b = pairs_.triangle_b(lane);
    const std::optional<FirstMeeting> first = find_first_meeting(a, b, work_);
    if (!first) return;
    if (first->at_start && !state_.leave_out_start) note_at_start(contact);
    if (first->at_start || state_.at_start) return;
    if (!state_.after_start.add(contact, {a, b, *first})) base_ += 2 * kExactPairWork;
    set_latest(state_.after_start.latest());
  }

  /// A step adds at most one item for each pair of slots.
  static constexpr std::uint32_t kMostNew = kMaxSlots * kMaxSlots;

  MovingSide a_, b_;
  FirstContactState& state_;
  MovingStats work_;
  WaitingMovingPairs pairs_;
  std::uint64_t base_;  ///< work without what `work_` counts in double and in exact arithmetic
  TimeSpan item_span_;  ///< of the clusters that are being tested
  TimedItem new_[kMostNew];
  std::uint32_t count_ = 0;
};

}  // namespace

MovingStats start_first_contact(const MovingTree& a, const MovingTree& b,
                                FirstContactState& state) {
  MovingStats work;
  state.work.start(kMovingNodePairWork + 4 * kRefitWork);
  if (!begin_descent(a, b, work)) return work;
  const auto all = static_cast<std::uint8_t>(kAllSlots);
  state.open.push({0, 1, 0, 0, 0, all, all, ItemStep::compare, 0});
  return work;
}

MovingStats advance_first_contact(const MovingTree& a, const MovingTree& b,
                                  FirstContactState& state) {
  return FirstContactSteps(a, b, state).run();
}

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail

#pragma once

/// Pairs of moving triangles. They wait until there are eight, for the certified float test
/// (moving_triage.hpp).

#include <pelt/motion.hpp>

#include "motion/moving_boxes.hpp"
#include "motion/moving_filter.hpp"
#include "motion/moving_polynomials.hpp"
#include "motion/moving_tree.hpp"
#include "motion/moving_triage.hpp"
#include "query/slots.hpp"
#include "query/triangle_batch.hpp"

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {

/// The boxes of a cluster's triangles at both ends.
struct MovingTriangleBoxes {
  explicit MovingTriangleBoxes(const MovingCluster& c)
      : from(triangle_boxes(c.moving.from, c.node, c.opened.from, c.slot)),
        to(triangle_boxes(c.moving.to, c.node, c.opened.to, c.slot)) {}

  /// Returns which of the triangles `asked` may overlap `box`, one bit each.
  template <typename Overlap>
  [[gnu::always_inline]] unsigned near(unsigned asked, const MovingBoxes8& box,
                                       const Overlap& overlap) const {
    unsigned found = 0;
    if ((asked & 0xFF) != 0) found = overlap(eight(0), box);
    if (asked >> 8 != 0) found |= overlap(eight(8), box) << 8;
    return asked & found;
  }

  /// One box in all lanes.
  MovingBoxes8 one(unsigned lane) const {
    return {repeat(lane_box(from.low, from.high, lane)), repeat(lane_box(to.low, to.high, lane))};
  }

  const TriangleBoxes &from, &to;

 private:
  [[gnu::always_inline]] MovingBoxes8 eight(unsigned first) const {
    return {load_boxes(from.low, from.high, first), load_boxes(to.low, to.high, first)};
  }
};

class WaitingMovingPairs {
 public:
  WaitingMovingPairs(const Tree& a, const Tree& b) : tree_a_(a), tree_b_(b) {}

  /// Adds the pairs of triangles of two clusters whose boxes may overlap. `overlap(boxes, boxes)`
  /// returns one bit for each lane, as OverlapUntil does. Calls `flush()` whenever there are eight
  /// pairs; it must call `clear`. Without the pairs whose bits are set in `skipped`, if given: bit
  /// t of row s for triangle s of `a` and triangle t of `b`.
  template <typename Overlap, typename Flush>
  void add(const MovingCluster& a, const MovingCluster& b, const Overlap& overlap,
           const Flush& flush, const std::uint16_t* skipped = nullptr);

  std::uint32_t count() const { return waiting_.count(); }
  void clear() { waiting_.clear(); }

  /// The corners of the pairs, one pair per lane; unused lanes repeat the first. Precondition:
  /// there is a pair.
  MovingPairs8 corners8();

  /// The same at time 0 only.
  TrianglePairs8 corners_at_start8();

  Contact contact(unsigned lane) const {
    const Pair& pair = waiting_[lane];
    return {tree_a_.triangle_ids[pair.a.triangle], tree_b_.triangle_ids[pair.b.triangle]};
  }

  MovingTriangle triangle_a(unsigned lane) const { return triangle(tree_a_, waiting_[lane].a); }
  MovingTriangle triangle_b(unsigned lane) const { return triangle(tree_b_, waiting_[lane].b); }

 private:
  /// A triangle and its posed pools.
  struct Side {
    std::uint32_t triangle;  ///< into Tree::corners
    const float *from, *to;
  };
  struct Pair {
    Side a, b;
  };

  static Side side(const MovingCluster& c, std::uint32_t number) {
    return {c.cluster().first_triangle + number, c.opened.from.positions, c.opened.to.positions};
  }

  static MovingBoxes8 box_of(const MovingCluster& c) {
    return {repeat(lane_box(c.opened.from.low, c.opened.from.high, c.slot)),
            repeat(lane_box(c.opened.to.low, c.opened.to.high, c.slot))};
  }

  static unsigned all_triangles(const MovingCluster& c) {
    return (1u << c.cluster().triangle_count) - 1;
  }

  static MovingTriangle triangle(const Tree& tree, const Side& side) {
    const auto& corners = tree.corners[side.triangle];
    return {corners_at([&](std::size_t k) { return side.from + corners[k]; }),
            corners_at([&](std::size_t k) { return side.to + corners[k]; })};
  }

  TrianglePairs8 corners8(const float* Side::*end) const;

  [[gnu::always_inline]] Points8 corner8(const Tree& tree, Side Pair::*side,
                                         const float* Side::*end, std::size_t k) const {
    return gather_points([&](std::uint32_t lane) __attribute__((always_inline)) {
      const Side& s = waiting_[lane].*side;
      return s.*end + tree.corners[s.triangle][k];
    });
  }

  const Tree &tree_a_, &tree_b_;
  Batch8<Pair> waiting_;
};

template <typename Overlap, typename Flush>
void WaitingMovingPairs::add(const MovingCluster& a, const MovingCluster& b, const Overlap& overlap,
                             const Flush& flush, const std::uint16_t* skipped) {
  const MovingTriangleBoxes boxes_a(a), boxes_b(b);
  const unsigned near_b = boxes_b.near(all_triangles(b), box_of(a), overlap);
  if (near_b == 0) return;
  const unsigned near_a = boxes_a.near(all_triangles(a), box_of(b), overlap);
  for (SetBits i(near_a); i; ++i) {
    const unsigned asked = skipped == nullptr ? near_b : near_b & ~unsigned{skipped[*i]};
    if (asked == 0) continue;
    for (SetBits k(boxes_b.near(asked, boxes_a.one(*i), overlap)); k; ++k) {
      waiting_.add({side(a, *i), side(b, *k)});
      if (waiting_.is_full()) flush();
    }
  }
}

inline MovingPairs8 WaitingMovingPairs::corners8() {
  waiting_.pad();
  return {corners8(&Side::from), corners8(&Side::to)};
}

inline TrianglePairs8 WaitingMovingPairs::corners_at_start8() {
  waiting_.pad();
  return corners8(&Side::from);
}

inline TrianglePairs8 WaitingMovingPairs::corners8(const float* Side::*end) const {
  TrianglePairs8 pairs;
  for (std::size_t k = 0; k < 3; ++k) {
    pairs.a[k] = corner8(tree_a_, &Pair::a, end, k);
    pairs.b[k] = corner8(tree_b_, &Pair::b, end, k);
  }
  return pairs;
}

/// The pairs of triangles of a batch that may intersect until a time.
class LanesUntil {
 public:
  /// Drops the pairs of `asked` that certainly do not intersect until `latest`.
  LanesUntil(const MovingPairs8& corners, unsigned asked, float latest) {
    const TimeSpans8 times = times_of_boxes(corners);
    times.start.store(starts_);
    const TimeSpans8 until_latest = {times.start, min(times.end, Float8(latest))};
    left_ = asked & ~moving_triage(corners, until_latest, 0).apart;
  }

  /// The pairs that are left, one bit each.
  unsigned left() const { return left_; }

  /// A time before which the pair does not intersect.
  float start(unsigned lane) const { return starts_[lane]; }

 private:
  unsigned left_;
  float starts_[8];
};

/// Decides about waiting pairs of moving triangles, eight at a time. Pairs that the certified float
/// test leaves undecided are decided one by one (moving_filter.hpp).
///
/// `Pairs` holds the waiting pairs:
///   std::uint32_t count() const                    how many, at most eight
///   MovingPairs8 corners8()                        one pair per lane
///   Contact contact(unsigned lane) const           the caller's numbers of the triangles
///   MovingTriangle triangle_a(unsigned lane) const, triangle_b(...)
///   void clear()
///
/// `Sink` takes the contacts: push(const MovingContact&)
template <typename Pairs, typename Sink>
class MovingTrianglePairs {
 public:
  MovingTrianglePairs(Pairs& pairs, Sink& sink, const MovingOptions& options, MovingStats& work)
      : pairs_(pairs), sink_(sink), options_(options), work_(work) {}

  /// Tests the waiting pairs.
  void flush() {
    const unsigned kept = (1u << pairs_.count()) - 1;
    if (kept == 0) return;
    const MovingPairs8 corners = pairs_.corners8();
    const unsigned at_start = kept & triage(corners.from).intersecting;
    const bool is_untimed = !options_.times && !options_.leave_out_start;
    const Triage verdict =
        moving_triage(corners, times_of_boxes(corners), options_.times ? 0 : kept & ~at_start);
    const unsigned left = kept & ~(at_start | verdict.apart);
    const unsigned untimed = is_untimed ? left & verdict.intersecting : 0;
    for (SetBits lane(at_start); lane; ++lane) report_at_start(*lane);
    for (SetBits lane(untimed); lane; ++lane) report_untimed(*lane);
    for (SetBits lane(left & ~untimed); lane; ++lane)
      decide(*lane, verdict.intersecting >> *lane & 1);
    work_.triangle_pairs += pairs_.count();
    pairs_.clear();
  }

 private:
  void report_at_start(unsigned lane) {
    if (options_.leave_out_start) return;
    sink_.push({pairs_.contact(lane), 0, options_.times, {}, {}});
  }

  void report_untimed(unsigned lane) { sink_.push({pairs_.contact(lane), 0, false, {}, {}}); }

  /// `is_certain`: whether the triangles certainly intersect at some time.
  void decide(unsigned lane, bool is_certain) {
    const MovingTriangle a = pairs_.triangle_a(lane), b = pairs_.triangle_b(lane);
    if (options_.times) return decide_when(lane, a, b);
    if (options_.leave_out_start && triangles_intersect(a.from, b.from)) return;
    if (is_certain || intersect_while_moving(a, b, work_)) report_untimed(lane);
  }

  void decide_when(unsigned lane, const MovingTriangle& a, const MovingTriangle& b) {
    const std::optional<FirstMeeting> first = find_first_meeting(a, b, work_);
    if (!first) return;
    if (first->at_start) return report_at_start(lane);
    sink_.push(moving_contact(pairs_.contact(lane), *first));
  }

  Pairs& pairs_;
  Sink& sink_;
  const MovingOptions& options_;
  MovingStats& work_;
};

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail

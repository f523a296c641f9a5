#pragma once

/// Decides about waiting pairs of moving triangles, eight at a time. What the certified float test
/// leaves undecided is decided one by one (moving_filter.hpp).
///
/// `Pairs` holds the waiting pairs:
///   std::uint32_t count() const                    how many, at most eight
///   MovingPairs8 corners8()                        one pair per lane
///   Contact contact(unsigned lane) const           the caller's numbers of the triangles
///   MovingTriangle triangle_a(unsigned lane) const, triangle_b(...)
///   void clear()
///
/// `Sink` takes the contacts: push(const MovingContact&)

#include <pelt/motion.hpp>

#include "motion/moving_filter.hpp"
#include "motion/moving_triage.hpp"
#include "query/slots.hpp"

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {

template <typename Pairs, typename Sink>
class MovingTriangles {
 public:
  MovingTriangles(Pairs& pairs, Sink& sink, const MovingOptions& options, MovingStats& work)
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

#pragma once

/// The pairs of triangles of a batch that may intersect until a time.

#include "motion/moving_triage.hpp"

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {

class LanesUntil {
 public:
  /// Of the pairs `asked`, leaves out those that certainly do not intersect until `latest`.
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

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail

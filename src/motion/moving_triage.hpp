#pragma once

/// The certified float test of eight pairs of moving triangles.

#include "geometry/triangle_triage.hpp"

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {

/// Eight pairs of moving triangles: lane i is pair i, at time 0 and at time 1.
struct MovingPairs8 {
  TrianglePairs8 from, to;
};

/// Eight spans of time, one per lane. Empty if `start` is after `end`.
struct TimeSpans8 {
  Float8 start, end;

  unsigned not_empty() const { return (start <= end).bits(); }
};

/// For each pair, times from 0 to 1 outside which the boxes of the triangles are disjoint. A pair
/// with an empty span never intersects.
TimeSpans8 times_of_boxes(const MovingPairs8& pairs);

/// Decides nearly all of the pairs `asked` in general position. `apart`: the triangles never
/// intersect; `intersecting`: they intersect at some time. Both as `first_meeting` decides. Of
/// other pairs, finds those that one plane or two edges separate at all times, half of all pairs.
///
/// Precondition: no pair intersects before its `start` or after its `end`, which are from 0 to 1.
/// For the coordinates, that of `triage`.
Triage moving_triage(const MovingPairs8& pairs, const TimeSpans8& times, unsigned asked);

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail

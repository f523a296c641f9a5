#pragma once

/// Computes when and where two moving triangles first meet, in exact arithmetic.

#include <pelt/motion.hpp>

#include "motion/moving_polynomials.hpp"

#include <optional>

namespace pelt::detail {

/// Where and when two moving triangles first meet.
struct FirstMeeting {
  /// The largest float32 that is not above the exact first time.
  float time = 0;

  /// Whether the triangles intersect at time 0. The features then have no meaning.
  bool at_start = false;

  /// The features of a and b that meet at the exact first time. If several pairs meet, this
  /// is the first one in this order: two corners, a corner and an edge, an edge and a corner, a
  /// corner and a face, a face and a corner, two edges; lower numbers of a first, then lower
  /// numbers of b.
  Feature a, b;

  friend bool operator==(const FirstMeeting&, const FirstMeeting&) = default;
};

/// Decides exactly whether two closed triangles intersect at any time from 0 to 1, and when first.
/// At each time, the triangles intersect as `triangles_intersect` defines. Their corners move in
/// straight lines between float32 positions, in exact arithmetic.
///
/// Cost: about 50 us; a few ms in the worst case. Uses about 260 KB of the stack. Never allocates.
/// Precondition: all coordinates are finite and below 2^61.
std::optional<FirstMeeting> first_meeting(const MovingTriangle& a, const MovingTriangle& b);

/// Returns the exact first time at which two triangles intersect. Precondition: it is after 0 and
/// before 1. Cost, stack and other preconditions: those of `first_meeting`.
CriticalTime first_time_of(const MovingTriangle& a, const MovingTriangle& b);

/// `first_meeting` for coordinates of up to kCoordinateBits bits.
std::optional<FirstMeeting> first_meeting(const MovingPoints& points);

}  // namespace pelt::detail

#pragma once

/// Finds out which of several pairs of moving triangles meets first.

#include <pelt/motion.hpp>

#include "motion/moving_pair.hpp"

#include <optional>

namespace pelt::detail {

/// Two moving triangles that meet after time 0, and their first meeting.
struct MeetingPair {
  MovingTriangle a, b;
  FirstMeeting first;
};

/// Returns -1 if p meets before q, 0 if both first meet at exactly the same time, 1 if p meets
/// after q.
///
/// Cost: if `certain_order` is empty, that of `first_meeting` for both pairs.
int compare_first_times(const MeetingPair& p, const MeetingPair& q);

/// The same, but without exact arithmetic. Empty if the floats of the times are equal, and it is
/// not certain that the same corners decide both.
std::optional<int> certain_order(const MeetingPair& p, const MeetingPair& q);

/// The pair of triangles that intersects first, of those added; of equal times, the lowest. Pairs
/// that intersect at time 0 are left out.
class EarliestPair {
 public:
  void add(const Contact& contact, const MovingTriangle& a, const MovingTriangle& b,
           MovingStats& work);

  /// Adds a pair that first meets after time 0. Returns whether the order of two equal times was
  /// certain without exact arithmetic, which takes as long as two pairs in exact arithmetic.
  bool add(const Contact& contact, const MeetingPair& pair);

  /// No time after this one is earlier than or equal to that of the earliest pair.
  float latest() const;

  /// Empty if no pair was added that intersects.
  std::optional<MovingContact> contact() const;

 private:
  Contact contact_;
  std::optional<MeetingPair> pair_;
};

}  // namespace pelt::detail

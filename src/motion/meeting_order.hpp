#pragma once

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

}  // namespace pelt::detail

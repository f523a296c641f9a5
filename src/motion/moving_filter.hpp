#pragma once

#include "motion/moving_pair.hpp"

#include <cstdint>
#include <optional>

namespace pelt::detail {

/// Whether two moving triangles intersect at any time from 0 to 1, and when first, as
/// `first_meeting` decides: in double if that is certain, and otherwise exactly. Cost: about 0.5
/// us. Precondition: that of `first_meeting`.
bool moving_triangles_intersect(const MovingTriangle& a, const MovingTriangle& b);
std::optional<FirstMeeting> filtered_first_meeting(const MovingTriangle& a,
                                                   const MovingTriangle& b);

// The stages in double.

enum class CertainAnswer : std::uint8_t { no, yes, unknown };

CertainAnswer certainly_intersect(const MovingTriangle& a, const MovingTriangle& b);

/// Returns false if the first meeting is not certain. Otherwise sets `meeting`.
bool find_certain_first_meeting(const MovingTriangle& a, const MovingTriangle& b,
                                std::optional<FirstMeeting>& meeting);

}  // namespace pelt::detail

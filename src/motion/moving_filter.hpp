#pragma once

/// Decides about pairs of moving triangles one by one: in double if that is certain, and otherwise
/// exactly. Counts the pairs of each stage.

#include <pelt/motion.hpp>

#include "motion/moving_pair.hpp"

#include <cstdint>
#include <optional>

namespace pelt::detail {

/// Whether two moving triangles intersect at any time from 0 to 1, and when first, as
/// `first_meeting` decides. Cost: about 0.5 us. Precondition: that of `first_meeting`.
bool intersect_while_moving(const MovingTriangle& a, const MovingTriangle& b, MovingStats& work);
std::optional<FirstMeeting> find_first_meeting(const MovingTriangle& a, const MovingTriangle& b,
                                               MovingStats& work);

MovingContact moving_contact(const Contact& contact, const FirstMeeting& first);

// The stages in double.

enum class CertainAnswer : std::uint8_t { no, yes, unknown };

CertainAnswer certainly_intersect(const MovingTriangle& a, const MovingTriangle& b);

/// Returns false if the first meeting is not certain. Otherwise sets `meeting`.
bool find_certain_first_meeting(const MovingTriangle& a, const MovingTriangle& b,
                                std::optional<FirstMeeting>& meeting);

}  // namespace pelt::detail

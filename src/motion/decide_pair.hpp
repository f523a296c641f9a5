#pragma once

/// Decides about pairs of moving triangles one by one, and counts the pairs of each stage.

#include <pelt/motion.hpp>

#include "motion/moving_pair.hpp"

#include <optional>

namespace pelt::detail {

/// Whether two triangles intersect at any time from 0 to 1.
bool intersect_while_moving(const MovingTriangle& a, const MovingTriangle& b, MovingStats& work);

std::optional<FirstMeeting> find_first_meeting(const MovingTriangle& a, const MovingTriangle& b,
                                               MovingStats& work);

MovingContact moving_contact(const Contact& contact, const FirstMeeting& first);

}  // namespace pelt::detail

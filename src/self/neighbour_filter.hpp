#pragma once

#include "self/moving_neighbours.hpp"

namespace pelt::detail {

/// Whether two triangles of a moving surface certainly never intersect, as
/// `first_meeting_of_neighbours` decides. Computes in double. Precondition: that of
/// `first_meeting`.
bool certainly_apart(const MovingSurfaceTriangle& a, const MovingSurfaceTriangle& b);

}  // namespace pelt::detail

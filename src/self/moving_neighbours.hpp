#pragma once

#include "motion/moving_pair.hpp"
#include "self/neighbour_pair.hpp"

#include <array>
#include <cstdint>
#include <optional>

namespace pelt::detail {

/// A moving triangle with the surface vertices of its corners.
struct MovingSurfaceTriangle {
  MovingTriangle corners;
  std::array<std::uint32_t, 3> vertices;
};

/// Decides exactly whether two triangles of one moving surface intersect at any time from 0 to 1,
/// and when first. At each time, they intersect as `surface_triangles_intersect` defines, and two
/// corners are shared if they have the same surface vertex and are at one position at this time.
///
/// The set of times need not be closed: triangles that are coplanar and folded open may begin to
/// overlap after an instant at which they do not. `time` then belongs to this instant, and the
/// triangles intersect immediately after it.
///
/// Of the features, those that have a shared corner in common are left out. If no pair of others
/// meets, both features are whole triangles.
///
/// Cost and preconditions: those of `first_meeting`.
std::optional<FirstMeeting> first_meeting_of_neighbours(const MovingSurfaceTriangle& a,
                                                        const MovingSurfaceTriangle& b);

}  // namespace pelt::detail

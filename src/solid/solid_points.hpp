#pragma once

#include <pelt/solid.hpp>

#include "base/vec3.hpp"
#include "geometry/triangle_distance.hpp"

#include <limits>

namespace pelt::detail {

/// A point of a triangle, a point of a solid, and their distance.
struct SolidPoints {
  double distance = std::numeric_limits<double>::infinity();
  Barycentrics at = {};
  Vec3d on_solid;
};

/// Definition of the distance of a triangle from a solid. Precondition: they do not touch.
SolidPoints closest_points(const TriangleCorners& triangle, const Solid& solid);

/// Returns a point of the triangle inside the solid, in the precision of double. Precondition: they
/// touch.
Barycentrics common_point(const TriangleCorners& triangle, const Solid& solid);

/// Error of the distance of a triangle, in units of kDistanceError: the largest coordinate of the
/// solid, times 2^24 for a box with rounded corners.
double extent_of(const Solid& solid);

}  // namespace pelt::detail

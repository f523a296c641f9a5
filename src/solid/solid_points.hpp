#pragma once

#include <pelt/solid.hpp>

#include "base/vec3.hpp"
#include "geometry/triangle_distance.hpp"

#include <limits>

namespace pelt::detail {

/// A point of a triangle and one of a solid, and how far they are apart.
struct SolidPoints {
  double distance = std::numeric_limits<double>::infinity();
  Barycentrics at = {};
  Vec3d on_solid;
};

/// *The* distance of a triangle from a solid. Precondition: they do not touch.
SolidPoints nearest_points(const TriangleCorners& triangle, const Solid& solid);

/// A point of the triangle that is in the solid, as precisely as double tells. Precondition: they
/// touch.
Barycentrics common_point(const TriangleCorners& triangle, const Solid& solid);

/// How much the distance of a triangle may be wrong, in units of kDistanceError: the largest
/// coordinate of the solid, and for rounded corners 2^24 times that of a box.
double extent_of(const Solid& solid);

}  // namespace pelt::detail

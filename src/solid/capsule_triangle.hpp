#pragma once

#include <pelt/math.hpp>

#include "geometry/triangle_pair.hpp"
#include "solid/faces_triangle.hpp"

namespace pelt::detail {

/// Returns exactly where a closed triangle lies with respect to a capsule. A sphere is a capsule
/// with equal ends. Precondition: all numbers are finite, and the radius is not negative.
TrianglePlace place_triangle(const TriangleCorners& triangle, const Capsule& capsule);

}  // namespace pelt::detail

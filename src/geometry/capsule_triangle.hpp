#pragma once

#include <pelt/shapes.hpp>

#include "geometry/faces_triangle.hpp"
#include "geometry/triangle_pair.hpp"

namespace pelt::detail {

/// Where a closed triangle lies with respect to a capsule, exactly; a sphere is one whose ends
/// coincide. Precondition: finite, the radius not negative.
TrianglePlace place_triangle(const TriangleCorners& triangle, const Capsule& capsule);

}  // namespace pelt::detail

#pragma once

#include "exact/exact_number.hpp"
#include "geometry/triangle_pair.hpp"

namespace pelt::detail {

/// Returns where an edge crosses the plane of a triangle: 0 at `from`, 1 at `to`. Precondition:
/// `from` and `to` are on different sides of the plane, or one of them is on it.
Rounded share_before_plane(const Vec3& from, const Vec3& to, const TriangleCorners& plane);

}  // namespace pelt::detail

#pragma once

#include <pelt/math.hpp>

#include <array>

namespace pelt::detail {

/// Corners of a posed triangle.
using TriangleCorners = std::array<Vec3, 3>;

/// Whether two closed triangles intersect, decided exactly on their float32 coordinates.
///
/// Touching and coplanar overlap count as intersection. A triangle that has collapsed to a segment
/// or a point is treated as that segment or point. The answer is symmetric and does not depend on
/// the order of the corners. Precondition: all coordinates are finite.
bool triangles_intersect(const TriangleCorners& a, const TriangleCorners& b);

}  // namespace pelt::detail

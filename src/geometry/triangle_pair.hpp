#pragma once

#include <pelt/math.hpp>

#include <array>

namespace pelt::detail {

/// Corners of a posed triangle.
using TriangleCorners = std::array<Vec3, 3>;

/// Whether two closed triangles intersect, decided exactly on their float32 coordinates.
///
/// Touching counts, coplanar overlap counts, and a triangle that has collapsed to a segment or a
/// point is that segment or point. Symmetric in its arguments and independent of the order of the
/// corners. Precondition: all coordinates are finite.
bool triangles_intersect(const TriangleCorners& a, const TriangleCorners& b);

}  // namespace pelt::detail

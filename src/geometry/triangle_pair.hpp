#pragma once

/// The exact test of two triangles.

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

/// Whether the corners lie on one line.
bool has_collapsed(const TriangleCorners& triangle);

/// Exact tests of pairs of closed triangles that two planes do not decide: coplanar pairs, and
/// pairs with a triangle that has collapsed to a segment or a point.

/// Whether the triangles intersect. Precondition: their boxes intersect, and every corner of each
/// triangle lies on the plane of the other, where the plane of a collapsed triangle is all of
/// space.
bool flat_triangles_intersect(const TriangleCorners& a, const TriangleCorners& b);

/// Whether a triangle that has collapsed to a segment intersects a triangle that has not.
/// Precondition: the ends of the segment are not on the same open side of the triangle's plane, and
/// not both on it.
bool segment_meets_triangle(const TriangleCorners& collapsed, const TriangleCorners& triangle);

}  // namespace pelt::detail

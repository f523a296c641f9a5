#pragma once

#include "geometry/triangle_pair.hpp"

namespace pelt::detail {

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

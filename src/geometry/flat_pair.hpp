#pragma once

#include "geometry/triangle_pair.hpp"

namespace pelt::detail {

/// Whether the corners lie on one line.
bool has_collapsed(const TriangleCorners& triangle);

/// The pairs of closed triangles that two planes cannot decide: coplanar ones, and those of which
/// one or both have collapsed to a segment or a point. Exact like triangles_intersect.

/// Whether the triangles intersect. Precondition: their boxes do, and every corner of either lies
/// on the plane of the other, where a collapsed triangle's plane is the whole space.
bool flat_triangles_intersect(const TriangleCorners& a, const TriangleCorners& b);

/// Whether a triangle that has collapsed to a segment meets one that has not. Precondition: the
/// ends of the segment are not on the same open side of the triangle's plane, nor both on it.
bool segment_meets_triangle(const TriangleCorners& collapsed, const TriangleCorners& triangle);

}  // namespace pelt::detail

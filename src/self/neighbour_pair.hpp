#pragma once

#include "geometry/triangle_pair.hpp"

#include <array>
#include <cstdint>

namespace pelt::detail {

/// A posed triangle with the surface vertices of its corners.
struct SurfaceTriangle {
  TriangleCorners corners;
  std::array<std::uint32_t, 3> vertices;
};

/// Whether two triangles of one surface intersect, apart from the corners that they share. Two
/// corners are shared if they have the same surface vertex and the same position. A crack opens
/// between two corners with the same surface vertex and different positions: these are not shared.
///
/// Decided exactly, by the number of distinct corners that the triangles share:
///
///   none    the closed triangles intersect
///   one     the edge opposite the shared corner, of one triangle, meets the other closed triangle
///   two     the triangles are folded flat: all corners lie in one plane, and the two corners that
///           are not shared lie strictly on the same side of the shared edge; or the third corner
///           of one triangle lies on the other closed triangle
///   all     always: the triangles are duplicates
///
/// A triangle with equal corners, such as (p, p, q), has two distinct corners or one. The edge
/// opposite p is then the point q; there may also be no such edge, or no third corner. A triangle
/// that has collapsed is treated as a segment or a point. The answer is symmetric and does not
/// depend on the order of the corners. Precondition: all coordinates are finite.
bool surface_triangles_intersect(const SurfaceTriangle& a, const SurfaceTriangle& b);

}  // namespace pelt::detail

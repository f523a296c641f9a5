/// The exact triangle pair test (Guigue & Devillers, "Fast and robust triangle-triangle overlap
/// test using orientation predicates", 2003). Every decision is the sign of an orientation
/// determinant, so exact signs make the test exact.
///
/// Two triangles whose planes cross in a line L intersect if the intervals in which they cut L
/// overlap. Rotate the vertices of each triangle so that its first vertex p, the apex, is farther
/// in front of the other's plane than q and r, and these are not in front of it. The interval then
/// extends from the point where the edge pq crosses L to the point where pr does. The order of two
/// such ends along L is again an orientation. Let i on p1q1 and k on p2q2 be ends, n1 and n2 the
/// normals, D = n1 x n2 the direction of L, u = q1 - p1 and w = q2 - p2. If the four points slide
/// along their lines,
///   orient3d(p1, q1, p2, q2) = sign of -(u x w) . (k - i),
///   (u x w) . D = (u . n1)(w . n2) - (u . n2)(w . n1) = 0 - (< 0)(< 0) < 0,
/// so orient3d is positive if k comes after i in the direction D. In this direction, the first
/// triangle's interval begins at p1r1, and the second's at p2q2. The intervals overlap if the end
/// at p2q2 does not come after the end at p1q1, and the end at p2r2 does not come before the end at
/// p1r1.

#include "geometry/triangle_pair.hpp"

#include "exact/predicates.hpp"
#include "geometry/pair_by_signs.hpp"

namespace pelt::detail {

bool triangles_intersect(const TriangleCorners& a, const TriangleCorners& b) {
  return corners_intersect(a, b);
}

bool has_collapsed(const TriangleCorners& triangle) {
  for (int axis = 0; axis < 3; ++axis) {
    const auto [a, b, c] = project(triangle, axis);
    if (orient2d(a, b, c) != 0) return false;
  }
  return true;
}

bool flat_triangles_intersect(const TriangleCorners& a, const TriangleCorners& b) {
  return flat_corners_intersect(a, b);
}

bool segment_meets_triangle(const TriangleCorners& collapsed, const TriangleCorners& triangle) {
  return segment_meets_corners(collapsed, triangle);
}

}  // namespace pelt::detail

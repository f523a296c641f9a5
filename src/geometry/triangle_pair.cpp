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

#include "geometry/flat_pair.hpp"
#include "geometry/plane_sides.hpp"
#include "geometry/predicates.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

namespace pelt::detail {
namespace {

bool all_on_one_open_side(const PlaneSides& s) { return s[0] != 0 && s[0] == s[1] && s[1] == s[2]; }

bool disjoint_range(float a0, float a1, float a2, float b0, float b1, float b2) {
  return std::max(std::max(a0, a1), a2) < std::min(std::min(b0, b1), b2) ||
         std::max(std::max(b0, b1), b2) < std::min(std::min(a0, a1), a2);
}

bool disjoint_boxes(const TriangleCorners& a, const TriangleCorners& b) {
  return disjoint_range(a[0].x, a[1].x, a[2].x, b[0].x, b[1].x, b[2].x) ||
         disjoint_range(a[0].y, a[1].y, a[2].y, b[0].y, b[1].y, b[2].y) ||
         disjoint_range(a[0].z, a[1].z, a[2].z, b[0].z, b[1].z, b[2].z);
}

/// The corner whose side is less than the sides of both others, or greater than both. Precondition:
/// the sides are not all equal.
std::size_t apex_index(const PlaneSides& s) {
  if (s[1] == s[2]) return 0;
  if (s[2] == s[0]) return 1;
  if (s[0] == s[1]) return 2;
  return s[0] > 0 ? 0 : s[1] > 0 ? 1 : 2;
}

/// The corners of a triangle in order, starting at the apex.
struct Turned {
  const Vec3 &p, *q, *r;
  bool apex_behind;  ///< p is behind the other's plane, or the others in front

  Turned(const TriangleCorners& t, const PlaneSides& s, std::size_t apex)
      : p(t[apex]),
        q(&t[(apex + 1) % 3]),
        r(&t[(apex + 2) % 3]),
        apex_behind(s[apex] < s[(apex + 1) % 3]) {}
};

/// Whether the triangles' intervals on the line of their planes overlap. Precondition: neither
/// triangle is on one open side of the other's plane, or on it.
bool intervals_overlap(const TriangleCorners& corners_a, const PlaneSides& sides_a,
                       const TriangleCorners& corners_b, const PlaneSides& sides_b) {
  Turned a(corners_a, sides_a, apex_index(sides_a));
  Turned b(corners_b, sides_b, apex_index(sides_b));
  if (a.apex_behind) std::swap(b.q, b.r);  // flips b's plane
  if (b.apex_behind) std::swap(a.q, a.r);
  return orient3d(a.p, *a.q, b.p, *b.q) <= 0 && orient3d(a.p, *a.r, b.p, *b.r) >= 0;
}

}  // namespace

bool triangles_intersect(const TriangleCorners& a, const TriangleCorners& b) {
  if (disjoint_boxes(a, b)) return false;
  const PlaneSides sides_a = sides_of(a, b);
  if (all_on_one_open_side(sides_a)) return false;
  const PlaneSides sides_b = sides_of(b, a);
  if (all_on_one_open_side(sides_b)) return false;

  // A collapsed triangle has no plane and every corner is on it, so a corner that is not proves
  // that the other triangle has not collapsed.
  const bool a_on_plane = all_on_plane(sides_a), b_on_plane = all_on_plane(sides_b);
  if (a_on_plane && b_on_plane) return flat_triangles_intersect(a, b);
  if (a_on_plane) return segment_meets_triangle(b, a);
  if (b_on_plane) return segment_meets_triangle(a, b);
  return intervals_overlap(a, sides_a, b, sides_b);
}

}  // namespace pelt::detail

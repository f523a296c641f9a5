#include "geometry/flat_pair.hpp"

#include "geometry/predicates.hpp"

#include <algorithm>
#include <array>
#include <tuple>

namespace pelt::detail {
namespace {

bool lexicographically_less(const Vec3& a, const Vec3& b) {
  return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
}

/// The first and last corner in lexicographic order: the ends of a collapsed triangle.
struct Ends {
  explicit Ends(const TriangleCorners& t)
      : first(*std::min_element(t.begin(), t.end(), lexicographically_less)),
        last(*std::max_element(t.begin(), t.end(), lexicographically_less)) {}

  Vec3 first, last;
};

using Triangle2 = std::array<Vec2d, 3>;

Triangle2 project(const TriangleCorners& t, int axis) {
  return {without(t[0], axis), without(t[1], axis), without(t[2], axis)};
}

/// Whether the line through p and q has the third corner r of its triangle on one closed side and
/// `other` on the opposite open side.
bool line_separates(const Vec2d& p, const Vec2d& q, const Vec2d& r, const Triangle2& other) {
  const int side = orient2d(p, q, other[0]);
  return side != 0 && orient2d(p, q, other[1]) == side && orient2d(p, q, other[2]) == side &&
         orient2d(p, q, r) != side;
}

bool edge_separates(const Triangle2& t, const Triangle2& other) {
  return line_separates(t[0], t[1], t[2], other) || line_separates(t[1], t[2], t[0], other) ||
         line_separates(t[2], t[0], t[1], other);
}

/// Whether two triangles in one plane are disjoint, given that their boxes are not.
///
/// On one line, disjoint ranges would have disjoint boxes, so the triangles intersect. Otherwise,
/// disjoint convex polygons are separated by the line of an edge of one of them. A separating line
/// in any projection along an axis proves disjointness. At least one of the three projections does
/// not collapse the plane, and a separating line is also found there.
bool disjoint_in_plane(const TriangleCorners& a, const TriangleCorners& b) {
  for (int axis = 0; axis < 3; ++axis) {
    const Triangle2 flat_a = project(a, axis), flat_b = project(b, axis);
    if (edge_separates(flat_a, flat_b) || edge_separates(flat_b, flat_a)) return true;
  }
  return false;
}

}  // namespace

bool has_collapsed(const TriangleCorners& triangle) {
  for (int axis = 0; axis < 3; ++axis) {
    const auto [a, b, c] = project(triangle, axis);
    if (orient2d(a, b, c) != 0) return false;
  }
  return true;
}

bool flat_triangles_intersect(const TriangleCorners& a, const TriangleCorners& b) {
  const Ends ends_a(a), ends_b(b);
  // Without a common plane, both triangles must be segments here.
  if (orient3d(ends_a.first, ends_a.last, ends_b.first, ends_b.last) != 0) return false;
  return !disjoint_in_plane(a, b);
}

bool segment_meets_triangle(const TriangleCorners& collapsed, const TriangleCorners& triangle) {
  const auto& [a, b, c] = triangle;
  const Ends ends(collapsed);
  // The line of the segment pierces the plane in one point. The point is inside unless the line
  // passes two edges on different sides.
  const int ab = orient3d(ends.first, ends.last, a, b);
  const int bc = orient3d(ends.first, ends.last, b, c);
  const int ca = orient3d(ends.first, ends.last, c, a);
  return std::min({ab, bc, ca}) >= 0 || std::max({ab, bc, ca}) <= 0;
}

}  // namespace pelt::detail

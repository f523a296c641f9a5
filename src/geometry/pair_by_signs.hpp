#pragma once

/// The exact triangle pair test as a template over points whose orientations have signs: corners of
/// posed triangles, or corners of moving triangles at one instant. `triangle_pair.cpp` explains the
/// test. It needs these functions of points p, q, r, s and of triangles a, b:
///
///   disjoint_boxes(a, b)            whether the coordinates on an axis have disjoint ranges
///   sides_of(a, b)                  for each corner of a, the sign of its orientation over b
///   orient3d(p, q, r, s)            the sign of det(q - p, r - p, s - p)
///   without(p, axis)                the point seen along an axis
///   orient2d(p', q', r')            the sign of det(q' - p', r' - p') of points seen along an axis
///   lexicographically_less(p, q)    a total order in which a segment's ends are first and last
///   flat_triangles_intersect(a, b)  as in `triangle_pair.hpp`: by `flat_corners_intersect`
///   segment_meets_triangle(a, b)    as in `triangle_pair.hpp`: by `segment_meets_corners`
///
/// The templates have internal linkage: a compiler inlines what a file calls once only if no other
/// file can call it.

#include "exact/predicates.hpp"
#include "geometry/triangle_pair.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <tuple>
#include <utility>

namespace pelt::detail {

/// The side of another triangle's plane for each corner of a triangle: 1 in front, -1 behind. If
/// the other triangle has collapsed, all corners are on its plane.
using PlaneSides = std::array<int, 3>;

inline PlaneSides sides_of(const TriangleCorners& corners, const TriangleCorners& plane) {
  const OrientedPlane oriented(plane[0], plane[1], plane[2]);
  return {oriented.side(corners[0]), oriented.side(corners[1]), oriented.side(corners[2])};
}

inline bool all_on_plane(const PlaneSides& s) { return s[0] == 0 && s[1] == 0 && s[2] == 0; }

// Posed triangles.

inline bool disjoint_range(float a0, float a1, float a2, float b0, float b1, float b2) {
  return std::max(std::max(a0, a1), a2) < std::min(std::min(b0, b1), b2) ||
         std::max(std::max(b0, b1), b2) < std::min(std::min(a0, a1), a2);
}

inline bool disjoint_boxes(const TriangleCorners& a, const TriangleCorners& b) {
  return disjoint_range(a[0].x, a[1].x, a[2].x, b[0].x, b[1].x, b[2].x) ||
         disjoint_range(a[0].y, a[1].y, a[2].y, b[0].y, b[1].y, b[2].y) ||
         disjoint_range(a[0].z, a[1].z, a[2].z, b[0].z, b[1].z, b[2].z);
}

inline bool lexicographically_less(const Vec3& a, const Vec3& b) {
  return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
}

// Pairs of any points that two planes do not decide.

template <typename Point>
using CornersOf = std::array<Point, 3>;

/// The first and last corner in lexicographic order: the ends of a collapsed triangle.
template <typename Point>
struct SegmentEnds {
  explicit SegmentEnds(const CornersOf<Point>& t)
      : first(*std::min_element(t.begin(), t.end(), before)),
        last(*std::max_element(t.begin(), t.end(), before)) {}

  Point first, last;

 private:
  static bool before(const Point& p, const Point& q) { return lexicographically_less(p, q); }
};

template <typename Point>
static auto project(const CornersOf<Point>& t, int axis) {
  return std::array{without(t[0], axis), without(t[1], axis), without(t[2], axis)};
}

/// Whether the line through p and q has the third corner r of its triangle on one closed side and
/// `other` on the opposite open side.
template <typename FlatPoint>
static bool line_separates(const FlatPoint& p, const FlatPoint& q, const FlatPoint& r,
                           const CornersOf<FlatPoint>& other) {
  const int side = orient2d(p, q, other[0]);
  return side != 0 && orient2d(p, q, other[1]) == side && orient2d(p, q, other[2]) == side &&
         orient2d(p, q, r) != side;
}

template <typename FlatPoint>
static bool edge_separates(const CornersOf<FlatPoint>& t, const CornersOf<FlatPoint>& other) {
  return line_separates(t[0], t[1], t[2], other) || line_separates(t[1], t[2], t[0], other) ||
         line_separates(t[2], t[0], t[1], other);
}

/// Whether two triangles in one plane are disjoint, given that their boxes are not.
///
/// On one line, disjoint ranges would have disjoint boxes, so the triangles intersect. Otherwise,
/// disjoint convex polygons are separated by the line of an edge of one of them. A separating line
/// in any projection along an axis proves disjointness. At least one of the three projections does
/// not collapse the plane, and a separating line is also found there.
template <typename Point>
static bool disjoint_in_plane(const CornersOf<Point>& a, const CornersOf<Point>& b) {
  for (int axis = 0; axis < 3; ++axis) {
    const auto flat_a = project(a, axis), flat_b = project(b, axis);
    if (edge_separates(flat_a, flat_b) || edge_separates(flat_b, flat_a)) return true;
  }
  return false;
}

template <typename Point>
static bool flat_corners_intersect(const CornersOf<Point>& a, const CornersOf<Point>& b) {
  const SegmentEnds<Point> ends_a(a), ends_b(b);
  // Without a common plane, both triangles must be segments here.
  if (orient3d(ends_a.first, ends_a.last, ends_b.first, ends_b.last) != 0) return false;
  return !disjoint_in_plane(a, b);
}

template <typename Point>
static bool segment_meets_corners(const CornersOf<Point>& collapsed,
                                  const CornersOf<Point>& triangle) {
  const auto& [a, b, c] = triangle;
  const SegmentEnds<Point> ends(collapsed);
  // The line of the segment pierces the plane in one point. The point is inside unless the line
  // passes two edges on different sides.
  const int ab = orient3d(ends.first, ends.last, a, b);
  const int bc = orient3d(ends.first, ends.last, b, c);
  const int ca = orient3d(ends.first, ends.last, c, a);
  return std::min({ab, bc, ca}) >= 0 || std::max({ab, bc, ca}) <= 0;
}

// All pairs of triangles.

inline bool all_on_one_open_side(const PlaneSides& s) {
  return s[0] != 0 && s[0] == s[1] && s[1] == s[2];
}

/// The corner whose side is less than the sides of both others, or greater than both. Precondition:
/// the sides are not all equal.
inline std::size_t apex_index(const PlaneSides& s) {
  if (s[1] == s[2]) return 0;
  if (s[2] == s[0]) return 1;
  if (s[0] == s[1]) return 2;
  return s[0] > 0 ? 0 : s[1] > 0 ? 1 : 2;
}

/// The corners of a triangle in order, starting at the apex.
template <typename Point>
struct Turned {
  const Point &p, *q, *r;
  bool apex_behind;  ///< p is behind the other's plane, or the others in front

  Turned(const CornersOf<Point>& t, const PlaneSides& s, std::size_t apex)
      : p(t[apex]),
        q(&t[(apex + 1) % 3]),
        r(&t[(apex + 2) % 3]),
        apex_behind(s[apex] < s[(apex + 1) % 3]) {}
};

/// Whether the triangles' intervals on the line of their planes overlap. Precondition: neither
/// triangle is on one open side of the other's plane, or on it.
template <typename Point>
static bool intervals_overlap(const CornersOf<Point>& corners_a, const PlaneSides& sides_a,
                              const CornersOf<Point>& corners_b, const PlaneSides& sides_b) {
  Turned<Point> a(corners_a, sides_a, apex_index(sides_a));
  Turned<Point> b(corners_b, sides_b, apex_index(sides_b));
  if (a.apex_behind) std::swap(b.q, b.r);  // flips b's plane
  if (b.apex_behind) std::swap(a.q, a.r);
  return orient3d(a.p, *a.q, b.p, *b.q) <= 0 && orient3d(a.p, *a.r, b.p, *b.r) >= 0;
}

template <typename Point>
static bool corners_intersect(const CornersOf<Point>& a, const CornersOf<Point>& b) {
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

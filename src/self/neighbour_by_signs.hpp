#pragma once

/// The test of two triangles that share corners (neighbour_pair.hpp) as a template over points, as
/// in `pair_by_signs.hpp`. In addition, it needs these functions:
///
///   coincide(p, q)          whether two corners are at one position
///   is_aside(part, other)   a quick test that proves that no rule holds, or false

#include "geometry/pair_by_signs.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace pelt::detail {

inline bool coincide(const Vec3& p, const Vec3& q) { return p == q; }

/// A triangle with the surface vertices of its corners.
template <typename Point>
struct SurfaceCornersOf {
  const CornersOf<Point>& corners;
  const std::array<std::uint32_t, 3>& vertices;
};

template <typename Point>
static bool is_same_corner(const SurfaceCornersOf<Point>& a, std::size_t i,
                           const SurfaceCornersOf<Point>& b, std::size_t k) {
  return a.vertices[i] == b.vertices[k] && coincide(a.corners[i], b.corners[k]);
}

/// The distinct corners of a triangle: those that the other triangle shares, and its own.
template <typename Point>
struct DistinctCorners {
  DistinctCorners(const SurfaceCornersOf<Point>& of, const SurfaceCornersOf<Point>& other) {
    for (std::size_t i = 0; i < 3; ++i)
      if (!has_corner(of, i, of, i))
        (has_corner(other, 3, of, i) ? shared[shared_count++] : own[own_count++]) = of.corners[i];
  }

  Point shared[3], own[3];
  std::size_t shared_count = 0, own_count = 0;

 private:
  /// Whether the first `count` corners of `t` include this corner.
  static bool has_corner(const SurfaceCornersOf<Point>& t, std::size_t count,
                         const SurfaceCornersOf<Point>& of, std::size_t corner) {
    for (std::size_t i = 0; i < count; ++i)
      if (is_same_corner(t, i, of, corner)) return true;
    return false;
  }
};

/// Whether the own corner, or the edge between the two own corners, meets the other triangle.
template <typename Point>
static bool own_part_meets(const DistinctCorners<Point>& part, const CornersOf<Point>& other) {
  if (part.own_count == 0) return false;
  return corners_intersect(CornersOf<Point>{part.own[0], part.own[part.own_count - 1], part.own[0]},
                           other);
}

/// Whether c and d lie in one plane with u and v, strictly on the same side of the line uv.
template <typename Point>
static bool is_folded_flat(const Point& u, const Point& v, const Point& c, const Point& d) {
  if (orient3d(u, v, c, d) != 0) return false;
  for (int axis = 0; axis < 3; ++axis) {
    const auto from = without(u, axis), to = without(v, axis);
    if (const int side = orient2d(from, to, without(c, axis)))
      return orient2d(from, to, without(d, axis)) == side;
  }
  return false;  // u, v and c are on one line
}

template <typename Point>
static bool surface_corners_intersect(const SurfaceCornersOf<Point>& a,
                                      const SurfaceCornersOf<Point>& b) {
  const DistinctCorners<Point> of_a(a, b), of_b(b, a);
  if (of_a.shared_count == 0) return corners_intersect(a.corners, b.corners);
  if (of_a.own_count == 0 && of_b.own_count == 0) return true;
  if (is_aside(of_a, b.corners) || is_aside(of_b, a.corners)) return false;
  if (own_part_meets(of_a, b.corners) || own_part_meets(of_b, a.corners)) return true;
  return of_a.shared_count == 2 && of_a.own_count == 1 && of_b.own_count == 1 &&
         is_folded_flat(of_a.shared[0], of_a.shared[1], of_a.own[0], of_b.own[0]);
}

}  // namespace pelt::detail

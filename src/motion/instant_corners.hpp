#pragma once

/// The corners of two moving triangles at one time, as points for the templates of the triangle
/// pair test (pair_by_signs.hpp).

#include "geometry/pair_by_signs.hpp"
#include "motion/instant_signs.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

namespace pelt::detail {

/// A corner of two moving triangles, at one time.
struct InstantCorner {
  InstantSigns* signs = nullptr;
  std::size_t corner = 0;
};

struct FlatInstantCorner {
  InstantSigns* signs = nullptr;
  std::size_t corner = 0, axis = 0;
};

using InstantTriangle = std::array<InstantCorner, 3>;

/// Returns -1, 0 or 1 if the coordinate of p is less than, equal to or greater than that of q.
inline int compare(const InstantCorner& p, const InstantCorner& q, std::size_t axis) {
  return p.signs->of(MovingPolynomials::compare(axis, q.corner, p.corner));
}

inline bool all_before(const InstantTriangle& a, const InstantTriangle& b, std::size_t axis) {
  return std::all_of(a.begin(), a.end(), [&](const InstantCorner& p) {
    return std::all_of(b.begin(), b.end(),
                       [&](const InstantCorner& q) { return compare(p, q, axis) < 0; });
  });
}

inline bool disjoint_boxes(const InstantTriangle& a, const InstantTriangle& b) {
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (all_before(a, b, axis) || all_before(b, a, axis)) return true;
  return false;
}

inline int orient3d(const InstantCorner& p, const InstantCorner& q, const InstantCorner& r,
                    const InstantCorner& s) {
  return p.signs->of(MovingPolynomials::orient3d({p.corner, q.corner, r.corner, s.corner}));
}

inline PlaneSides sides_of(const InstantTriangle& corners, const InstantTriangle& plane) {
  const auto side = [&](const InstantCorner& p) {
    return orient3d(plane[0], plane[1], plane[2], p);
  };
  return {side(corners[0]), side(corners[1]), side(corners[2])};
}

inline FlatInstantCorner without(const InstantCorner& p, int axis) {
  return {p.signs, p.corner, static_cast<std::size_t>(axis)};
}

inline int orient2d(const FlatInstantCorner& p, const FlatInstantCorner& q,
                    const FlatInstantCorner& r) {
  return p.signs->of(MovingPolynomials::orient2d(p.axis, {p.corner, q.corner, r.corner}));
}

inline bool lexicographically_less(const InstantCorner& p, const InstantCorner& q) {
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (const int order = compare(p, q, axis)) return order < 0;
  return false;
}

inline bool flat_triangles_intersect(const InstantTriangle& a, const InstantTriangle& b) {
  return flat_corners_intersect(a, b);
}

inline bool segment_meets_triangle(const InstantTriangle& collapsed,
                                   const InstantTriangle& triangle) {
  return segment_meets_corners(collapsed, triangle);
}

/// Numbers of three corners of six: first those of a, then those of b. Corners may be repeated.
using CornerNumbers = std::array<std::size_t, 3>;

/// Whether the hulls of two triples of corners intersect.
inline bool hulls_meet(InstantSigns& signs, const CornerNumbers& a, const CornerNumbers& b) {
  const auto corner = [&](std::size_t i) { return InstantCorner{&signs, i}; };
  return corners_intersect(InstantTriangle{corner(a[0]), corner(a[1]), corner(a[2])},
                           InstantTriangle{corner(b[0]), corner(b[1]), corner(b[2])});
}

}  // namespace pelt::detail

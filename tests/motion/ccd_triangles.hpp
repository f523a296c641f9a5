#pragma once

/// Queries of collections as collapsed triangles: {v, v, v} and the face, or {a, b, b} and
/// {c, d, d}.

#include "ccd_queries.hpp"
#include "exact/gmp_integers.hpp"
#include "motion/moving_polynomials.hpp"
#include "moving_oracle.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>

namespace pelt::test {

/// The number of the query's point for each corner of the two triangles.
inline std::array<std::size_t, 6> points_of_corners(CcdKind kind) {
  if (kind == CcdKind::vertex_face) return {0, 0, 0, 1, 2, 3};
  return {0, 1, 1, 2, 3, 3};
}

/// The corners in units of which all coordinates on an axis are multiples, as large as possible.
inline MovingCorners moving_corners(const CcdQuery& query) {
  const auto points = points_of_corners(query.kind);
  MovingCorners corners;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    mpz_class below = 1, common;
    for (const RationalPoint& p : query.points) below = lcm(below, p[axis].get_den());
    for (const RationalPoint& p : query.points)
      common = gcd(common, mpz_class(p[axis].get_num() * (below / p[axis].get_den())));
    if (common == 0) common = 1;
    const auto coordinate = [&](std::size_t point) {
      const mpq_class& x = query.points[point][axis];
      return mpz_class(x.get_num() * (below / x.get_den()) / common);
    };
    for (std::size_t i = 0; i < 6; ++i)
      corners[i][axis] = {coordinate(points[i]), coordinate(points[i] + 4)};
  }
  return corners;
}

/// The same for the library's exact test. Nullopt if coordinates have too many bits.
inline std::optional<detail::MovingPoints> moving_points(const MovingCorners& corners) {
  detail::MovingPoints result;
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto& [from, to] = corners[i][axis];
      if (std::max(bits_of(from), bits_of(to)) > detail::kCoordinateBits) return std::nullopt;
      using Integer = decltype(detail::MovingCoordinate::from);
      result[i][axis] = {from_gmp<Integer>(from), from_gmp<Integer>(to)};
    }
  return result;
}

struct CollapsedTriangles {
  detail::MovingTriangle a, b;
};

/// Nullopt if a coordinate is not a float32, or too large for the library.
inline std::optional<CollapsedTriangles> collapsed_triangles(const CcdQuery& query) {
  const auto is_float = [](const mpq_class& x) {
    return abs(x) < 0x1p61 && mpq_class(static_cast<float>(x.get_d())) == x;
  };
  for (const RationalPoint& p : query.points)
    if (!std::all_of(p.begin(), p.end(), is_float)) return std::nullopt;
  const auto position = [&](std::size_t point) {
    const auto& [x, y, z] = query.points[point];
    return Vec3{static_cast<float>(x.get_d()), static_cast<float>(y.get_d()),
                static_cast<float>(z.get_d())};
  };
  const auto points = points_of_corners(query.kind);
  CollapsedTriangles result;
  for (std::size_t i = 0; i < 6; ++i) {
    detail::MovingTriangle& triangle = i < 3 ? result.a : result.b;
    triangle.from[i % 3] = position(points[i]);
    triangle.to[i % 3] = position(points[i] + 4);
  }
  return result;
}

}  // namespace pelt::test

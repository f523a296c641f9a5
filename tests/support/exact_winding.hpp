#pragma once

/// Inside and outside by integer arithmetic and brute force: intersects every triangle with a ray
/// in a random direction, and tries another direction if the ray meets an edge. Shares only the
/// definition with the library.

#include "motion/hulls_meet.hpp"

#include <pelt/inside.hpp>
#include <pelt/mesh.hpp>

#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <optional>
#include <random>
#include <span>

namespace pelt::test {

using BigPoint = IntegerPoint<mpz_class>;
using BigTriangle = IntegerTriangle<mpz_class>;

/// The coordinate in units of 2^-149; every float is a multiple of this.
inline mpz_class to_big(float value) {
  return mpz_class(mpf_class(mpf_class(static_cast<double>(value), 512) << 149));
}
inline BigPoint to_big(const Vec3& p) { return {to_big(p.x), to_big(p.y), to_big(p.z)}; }

class ExactWinding {
 public:
  ExactWinding(std::span<const Vec3> posed, std::span<const Triangle> triangles) {
    for (const Triangle& t : triangles)
      triangles_.push_back({to_big(posed[t[0]]), to_big(posed[t[1]]), to_big(posed[t[2]])});
  }

  PointSide side_of(const Vec3& point) {
    const std::optional<int> number = winding_number(point);
    if (!number) return PointSide::on;
    return *number != 0 ? PointSide::inside : PointSide::outside;
  }

  /// Nullopt if the point is on the surface.
  std::optional<int> winding_number(const Vec3& point) {
    const BigPoint origin = to_big(point);
    for (const BigTriangle& t : triangles_)
      if (hulls_meet<mpz_class>({origin, origin, origin}, t)) return std::nullopt;
    for (;;)
      if (const auto number = winding_along(random_direction(), origin)) return number;
  }

 private:
  BigPoint random_direction() {
    // Without the return type, the lambda would return an expression of GMP with dangling
    // references.
    const auto coordinate = [&]() -> mpz_class {
      return mpz_class(static_cast<long>(random_() >> 20)) - (mpz_class(1) << 43);
    };
    return {coordinate(), coordinate(), coordinate()};
  }

  static mpz_class determinant(const BigPoint& p, const BigPoint& q, const BigPoint& r) {
    return p[0] * (q[1] * r[2] - q[2] * r[1]) + p[1] * (q[2] * r[0] - q[0] * r[2]) +
           p[2] * (q[0] * r[1] - q[1] * r[0]);
  }

  /// Nullopt if the ray meets an edge.
  std::optional<int> winding_along(const BigPoint& direction, const BigPoint& origin) const {
    int number = 0;
    for (const BigTriangle& t : triangles_) {
      std::array<BigPoint, 3> seen;
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t axis = 0; axis < 3; ++axis) seen[i][axis] = t[i][axis] - origin[axis];
      std::array<int, 3> sides;
      for (std::size_t i = 0; i < 3; ++i)
        sides[i] = sgn(determinant(direction, seen[(i + 1) % 3], seen[(i + 2) % 3]));
      const auto [least, most] = std::minmax({sides[0], sides[1], sides[2]});
      if (least < 0 && most > 0) continue;
      if (least == 0 && most == 0 && is_collapsed(t)) continue;
      if (std::count(sides.begin(), sides.end(), 0) > 0) return std::nullopt;
      // The ray's parameter is this determinant, divided by one with the sign of the sides.
      const int ahead = sgn(determinant(seen[0], seen[1], seen[2])) * sides[0];
      if (ahead > 0) number += sides[0];
    }
    return number;
  }

  static bool is_collapsed(const BigTriangle& t) {
    std::array<mpz_class, 3> u, v;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      u[axis] = t[1][axis] - t[0][axis];
      v[axis] = t[2][axis] - t[0][axis];
    }
    return u[1] * v[2] == u[2] * v[1] && u[2] * v[0] == u[0] * v[2] && u[0] * v[1] == u[1] * v[0];
  }

  std::vector<BigTriangle> triangles_;
  std::mt19937_64 random_{1};
};

}  // namespace pelt::test

#pragma once

#include "geometry/triangle_pair.hpp"
#include "motion/hulls_meet.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <random>
#include <string>

namespace pelt::test {

/// Pairs of triangles with integer coordinates, |coordinate| <= kLimit: an exact reference can use
/// them directly, and scaled by a power of two they are float32.
inline constexpr std::int64_t kLimit = (1 << 24) - 1;

using Random = std::mt19937_64;
using Point = IntegerPoint<std::int64_t>;
using IntegerCorners = IntegerTriangle<std::int64_t>;

/// Prints the seed.
inline Random seeded(std::uint64_t seed) {
  std::cout << "seed " << seed << "\n";
  return Random(seed);
}

struct IntegerPair {
  IntegerCorners a, b;
};

inline std::int64_t uniform(Random& random, std::int64_t low, std::int64_t high) {
  return std::uniform_int_distribution<std::int64_t>(low, high)(random);
}

inline Point uniform_point(Random& random, std::int64_t low, std::int64_t high) {
  return {uniform(random, low, high), uniform(random, low, high), uniform(random, low, high)};
}

inline IntegerCorners uniform_corners(Random& random, std::int64_t low, std::int64_t high) {
  return {uniform_point(random, low, high), uniform_point(random, low, high),
          uniform_point(random, low, high)};
}

inline Point operator+(const Point& p, const Point& q) {
  return {p[0] + q[0], p[1] + q[1], p[2] + q[2]};
}
inline Point operator*(std::int64_t s, const Point& p) { return {s * p[0], s * p[1], s * p[2]}; }
inline Point operator-(const Point& p, const Point& q) { return p + (-1) * q; }

inline Point middle(const Point& p, const Point& q) {
  return {(p[0] + q[0]) / 2, (p[1] + q[1]) / 2, (p[2] + q[2]) / 2};
}

/// Random positions; in one pair of eight, a vertex of one triangle is in the middle of an edge of
/// the other, up to rounding.
inline IntegerPair anywhere(Random& random) {
  IntegerPair pair = {uniform_corners(random, -kLimit, kLimit),
                      uniform_corners(random, -kLimit, kLimit)};
  if (random() % 8 == 0) pair.b[random() % 3] = middle(pair.a[0], pair.a[1]);
  return pair;
}

/// On a small grid, where most pairs are coplanar, touch or are degenerate.
inline IntegerPair on_grid(Random& random) {
  return {uniform_corners(random, 0, 3), uniform_corners(random, 0, 3)};
}

/// On a grid in one sloping plane.
inline IntegerPair in_plane(Random& random) {
  IntegerPair pair = {uniform_corners(random, 0, 6), uniform_corners(random, 0, 6)};
  for (IntegerCorners* corners : {&pair.a, &pair.b}) {
    for (Point& p : *corners) p[2] = 2 * p[0] - 3 * p[1];
  }
  return pair;
}

/// Collapses a triangle to a point, to a segment between two vertices, or to a segment with a
/// vertex inside.
inline void collapse(Random& random, IntegerCorners& corners) {
  auto& [p, q, r] = corners;
  switch (random() % 4) {
    case 0:
      q = r = p;
      break;
    case 1:
      r = q;
      break;
    case 2:
      r = p;
      break;
    default:
      q = 2 * r - p;
      break;
  }
}

/// On a small grid; the first triangle is collapsed, and in every other pair also the second.
inline IntegerPair collapsed(Random& random) {
  IntegerPair pair = on_grid(random);
  collapse(random, pair.a);
  if (random() % 2) collapse(random, pair.b);
  if (random() % 2) std::swap(pair.a, pair.b);
  return pair;
}

/// A point of the triangle's plane, inside or near the triangle, rounded and moved by at most one
/// unit.
inline Point near_plane(Random& random, const IntegerCorners& t) {
  std::uniform_real_distribution<double> weight(-0.25, 1);
  const double u = weight(random), v = weight(random);
  Point p;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double exact = (1 - u - v) * static_cast<double>(t[0][axis]) +
                         u * static_cast<double>(t[1][axis]) + v * static_cast<double>(t[2][axis]);
    p[axis] = std::llround(exact) + uniform(random, -1, 1);
  }
  return p;
}

/// The second triangle is within a unit of the first one's plane; in every other pair, one vertex
/// is exactly on it.
inline IntegerPair nearly_coplanar(Random& random) {
  IntegerPair pair;
  pair.a = uniform_corners(random, -kLimit / 4, kLimit / 4);
  for (Point& p : pair.b) p = near_plane(random, pair.a);
  if (random() % 2) pair.b[0] = pair.a[0] + pair.a[1] - pair.a[2];
  return pair;
}

/// Pairs on a small grid, transformed by a linear map with determinant one and coefficients of
/// 2^20. The map preserves volumes of one unit while coordinates grow, far closer to coplanar than
/// double can distinguish.
inline IntegerPair sheared_grid(Random& random) {
  IntegerPair pair = on_grid(random);
  IntegerCorners images = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  const auto bounded = [](std::int64_t x) { return std::abs(x) < kLimit / 18; };
  while (true) {
    const auto from = random() % 3, to = (from + 1 + random() % 2) % 3;
    const Point sum = random() % 2 ? images[to] + images[from] : images[to] - images[from];
    if (!std::all_of(sum.begin(), sum.end(), bounded)) break;
    images[to] = sum;
  }
  for (IntegerCorners* corners : {&pair.a, &pair.b}) {
    for (Point& p : *corners) p = p[0] * images[0] + p[1] * images[1] + p[2] * images[2];
  }
  return pair;
}

/// A sliver: two vertices far apart, the third within a unit of the line between them; and another
/// triangle with two vertices near the same line.
inline IntegerPair slivers(Random& random) {
  IntegerPair pair;
  pair.a = uniform_corners(random, -kLimit / 4, kLimit / 4);
  pair.a[2] = pair.a[1];
  pair.b = {near_plane(random, pair.a), near_plane(random, pair.a),
            uniform_point(random, -kLimit / 4, kLimit / 4)};
  pair.a[2] = near_plane(random, pair.a);
  return pair;
}

/// The vertices times 2^exponent.
inline detail::TriangleCorners scaled(const IntegerCorners& corners, int exponent) {
  detail::TriangleCorners result;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto coordinate = [&](std::size_t axis) {
      return static_cast<float>(std::ldexp(static_cast<double>(corners[i][axis]), exponent));
    };
    result[i] = {coordinate(0), coordinate(1), coordinate(2)};
  }
  return result;
}

/// In hexadecimal, for copying into a test.
inline std::string to_text(const detail::TriangleCorners& corners) {
  std::string text = "{";
  for (const Vec3& p : corners) {
    std::array<char, 100> buffer;
    std::snprintf(buffer.data(), buffer.size(), "{%af, %af, %af}, ", double{p.x}, double{p.y},
                  double{p.z});
    text += buffer.data();
  }
  return text + "}";
}

}  // namespace pelt::test

#include "geometry/ray_triangle.hpp"

#include "exact/finite_floats.hpp"
#include "triangle_cases.hpp"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <limits>

namespace pelt::test {
namespace {

using detail::RayCrossing;
using detail::RayLine;
using detail::TriangleCorners;

using ExactVector = std::array<mpz_class, 3>;

/// Every float times 2^149 is an integer.
ExactVector exact(const Vec3& v) {
  const auto integer = [](float x) { return mpz_class(std::ldexp(double{x}, 149)); };
  return {integer(v.x), integer(v.y), integer(v.z)};
}

ExactVector difference(const ExactVector& p, const ExactVector& q) {
  return {p[0] - q[0], p[1] - q[1], p[2] - q[2]};
}

ExactVector cross(const ExactVector& p, const ExactVector& q) {
  return {p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]};
}

mpz_class dot(const ExactVector& p, const ExactVector& q) {
  return p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
}

mpq_class ratio(const mpz_class& numerator, const mpz_class& denominator) {
  mpq_class result(numerator, denominator);
  result.canonicalize();
  return result;
}

/// 2^128 represents infinity.
mpq_class value_of(float x) {
  return std::isfinite(x) ? mpq_class(x) : mpq_class(std::copysign(0x1p128, x));
}

/// The nearest float, ties to even, found among neighbours by exact distances.
float nearest_float(const mpq_class& q) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  if (abs(q) >= value_of(kInfinity)) return q > 0 ? kInfinity : -kInfinity;
  float below = static_cast<float>(q.get_d());
  while (value_of(below) > q) below = std::nextafter(below, -kInfinity);
  float above = below;
  while (value_of(above) < q) above = std::nextafter(above, kInfinity);
  const mpq_class to_below = q - value_of(below), to_above = value_of(above) - q;
  if (to_below != to_above) return to_below < to_above ? below : above;
  return (std::bit_cast<std::uint32_t>(below) & 1) == 0 ? below : above;
}

/// The result by definition, in integers.
struct Expected {
  Expected(const RayLine& line, const TriangleCorners& t) {
    const ExactVector o = exact(line.origin), d = exact(line.direction);
    const ExactVector a = difference(exact(t[0]), o), b = difference(exact(t[1]), o);
    const ExactVector c = difference(exact(t[2]), o);
    normal = cross(difference(b, a), difference(c, a));
    slope = dot(d, normal);
    edges = {dot(d, cross(b, c)), dot(d, cross(c, a)), dot(d, cross(a, b))};
    const auto has_sign = [&](int sign) {
      return sgn(edges[0]) == sign || sgn(edges[1]) == sign || sgn(edges[2]) == sign;
    };
    if (slope == 0 || (has_sign(1) && has_sign(-1))) return;
    t_value = ratio(dot(a, normal), slope);
    crossing.t = nearest_float(t_value) + 0.0f;
    crossing.from_front = slope < 0;
    crossing.on_edge = {edges[0] == 0, edges[1] == 0, edges[2] == 0};
    meets = std::isfinite(crossing.t);
  }

  ExactVector normal;
  mpz_class slope;
  std::array<mpz_class, 3> edges;
  mpq_class t_value;
  bool meets = false;
  RayCrossing crossing;
};

struct Counts {
  int meets = 0, misses = 0, on_edge = 0, on_corner = 0, parallel = 0;
};

void expect_weights(const RayLine& line, const TriangleCorners& triangle,
                    const Expected& expected) {
  const auto weights = detail::crossing_weights(line, triangle, expected.crossing);
  for (std::size_t k = 0; k < 3; ++k) {
    const double exact_weight = ratio(expected.edges[k], expected.slope).get_d();
    ASSERT_NEAR(double{weights[k]}, exact_weight, 0x1p-23) << to_text(triangle);
    ASSERT_GE(weights[k], 0);
    ASSERT_TRUE(!expected.crossing.on_edge[k] || weights[k] == 0);
  }
}

void expect_normal(const TriangleCorners& triangle, const Expected& expected) {
  const Vec3 unit = detail::unit_normal(triangle);
  const mpf_class length = sqrt(mpf_class(dot(expected.normal, expected.normal), 4096));
  const auto component = [&](std::size_t axis) {
    return mpf_class(mpf_class(expected.normal[axis], 4096) / length).get_d();
  };
  ASSERT_NEAR(double{unit.x}, component(0), 0x1p-22) << to_text(triangle);
  ASSERT_NEAR(double{unit.y}, component(1), 0x1p-22) << to_text(triangle);
  ASSERT_NEAR(double{unit.z}, component(2), 0x1p-22) << to_text(triangle);
}

void expect_as_defined(const RayLine& line, const TriangleCorners& triangle, Counts& counts) {
  const Expected expected(line, triangle);
  RayCrossing crossing;
  ASSERT_EQ(detail::line_meets_triangle(line, triangle, crossing), expected.meets)
      << to_text(triangle);
  counts.parallel += expected.slope == 0;
  ++(expected.meets ? counts.meets : counts.misses);
  if (!expected.meets) return;
  ASSERT_EQ(crossing.t, expected.crossing.t) << to_text(triangle);
  ASSERT_FALSE(crossing.t == 0 && std::signbit(crossing.t));
  ASSERT_EQ(crossing.from_front, expected.crossing.from_front);
  ASSERT_EQ(crossing.on_edge, expected.crossing.on_edge);
  const auto [a, b, c] = crossing.on_edge;
  counts.on_edge += a || b || c;
  counts.on_corner += a + b + c == 2;
  expect_weights(line, triangle, expected);
  expect_normal(triangle, expected);
}

Vec3 as_float(const Point& p, int exponent) {
  const auto coordinate = [&](std::size_t axis) {
    return static_cast<float>(std::ldexp(static_cast<double>(p[axis]), exponent));
  };
  return {coordinate(0), coordinate(1), coordinate(2)};
}

/// A ray from the first vertex of the second triangle to another vertex of it, through a vertex or
/// the middle of an edge of the first triangle, or to a point near these.
RayLine line_of(Random& random, const IntegerPair& pair, int exponent) {
  const Point& origin = pair.b[0];
  const auto target = [&]() -> Point {
    switch (random() % 5) {
      case 0:
        return pair.b[1];
      case 1:
        return pair.a[random() % 3];
      case 2:
        return middle(pair.a[random() % 3], pair.a[random() % 3]);
      case 3:
        return middle(middle(pair.a[0], pair.a[1]), pair.a[2]);
      default:
        return near_plane(random, pair.a);
    }
  };
  return {as_float(origin, exponent),
          as_float(target() - origin, exponent - static_cast<int>(random() % 3))};
}

Counts run(std::uint64_t seed, int cases, IntegerPair (*generate)(Random&)) {
  std::cout << "seed " << seed << "\n";
  Random random(seed);
  Counts counts;
  for (int i = 0; i < cases; ++i) {
    const IntegerPair pair = generate(random);
    const int exponent = std::array{0, -149, 100, -24}[random() % 4];
    expect_as_defined(line_of(random, pair, exponent), scaled(pair.a, exponent), counts);
    if (::testing::Test::HasFatalFailure()) break;
  }
  std::cout << counts.meets << " meet, " << counts.misses << " miss, " << counts.on_edge
            << " on an edge, " << counts.on_corner << " on a corner, " << counts.parallel
            << " parallel\n";
  return counts;
}

TEST(RayTriangle, SeesTheFrontWhereCornersTurnCounterClockwise) {
  const TriangleCorners triangle = {Vec3{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
  RayCrossing crossing;
  ASSERT_TRUE(detail::line_meets_triangle({{1, 2, 3}, {0, 0, -2}}, triangle, crossing));
  EXPECT_TRUE(crossing.from_front);
  EXPECT_EQ(crossing.t, 1.5f);
  const auto weights = detail::crossing_weights({{1, 2, 3}, {0, 0, -2}}, triangle, crossing);
  EXPECT_EQ(weights, (std::array{0.25f, 0.25f, 0.5f}));
  EXPECT_EQ(detail::unit_normal(triangle), (Vec3{0, 0, 1}));
  ASSERT_TRUE(detail::line_meets_triangle({{1, 2, 3}, {0, 0, 2}}, triangle, crossing));
  EXPECT_FALSE(crossing.from_front);
  EXPECT_EQ(crossing.t, -1.5f);
}

TEST(RayTriangle, IsAsDefinedAnywhere) {
  const Counts counts = run(31, 40'000, anywhere);
  EXPECT_GT(counts.meets, 10'000);
  EXPECT_GT(counts.misses, 5'000);
}

TEST(RayTriangle, IsAsDefinedOnAGrid) {
  const Counts counts = run(32, 40'000, on_grid);
  EXPECT_GT(counts.on_edge, 5'000);
  EXPECT_GT(counts.on_corner, 2'000);
  EXPECT_GT(counts.parallel, 2'000);
}

TEST(RayTriangle, IsAsDefinedFarCloserThanDoubleSees) {
  const Counts counts = run(33, 40'000, sheared_grid);
  EXPECT_GT(counts.meets, 5'000);
  EXPECT_GT(counts.misses, 5'000);
  EXPECT_GT(counts.parallel, 2'000);
}

TEST(RayTriangle, IsAsDefinedAlongPlanesAndOfSlivers) {
  EXPECT_GT(run(34, 20'000, nearly_coplanar).meets, 2'000);
  EXPECT_GT(run(35, 20'000, slivers).meets, 2'000);
  EXPECT_GT(run(36, 20'000, in_plane).parallel, 5'000);
}

TEST(RayTriangle, NeverHitsCollapsedTriangles) {
  Random random(37);
  for (int i = 0; i < 10'000; ++i) {
    IntegerCorners corners = uniform_corners(random, 0, 3);
    collapse(random, corners);
    const RayLine line = {as_float(uniform_point(random, 0, 3), 0),
                          as_float(uniform_point(random, -3, 3), 0)};
    RayCrossing crossing;
    ASSERT_FALSE(detail::line_meets_triangle(line, scaled(corners, 0), crossing));
  }
}

TEST(RayTriangle, IsAsDefinedOfAnyFloats) {
  Random random(38);
  Counts counts;
  for (int i = 0; i < 100'000; ++i) {
    const auto coordinate = i % 2 ? any_finite_float : one_of_few_floats;
    const TriangleCorners triangle = corners_of(random, coordinate);
    const auto [origin, direction, other] = corners_of(random, coordinate);
    ASSERT_NO_FATAL_FAILURE(expect_as_defined({origin, direction}, triangle, counts));
  }
  EXPECT_GT(counts.meets, 10'000);
  EXPECT_GT(counts.on_edge, 200);
}

/// With t halfway between two floats, or slightly off.
TEST(RayTriangle, RoundsTToTheNearestFloat) {
  Random random(39);
  Counts counts;
  int halfway = 0;
  for (int i = 0; i < 20'000; ++i) {
    const auto height = static_cast<float>(uniform(random, kLimit / 2, kLimit));
    const float step = std::array{0.0f, 0x1p-25f, -0x1p-25f, 0x1p-60f}[random() % 4];
    const TriangleCorners triangle = {Vec3{-1, -1, height}, {3, -1, height}, {-1, 3, height}};
    const RayLine line = {{0, 0, -0.5f + step}, {0, 0, random() % 2 ? 1.0f : 3.0f}};
    halfway += step == 0 && line.direction.z == 1;
    ASSERT_NO_FATAL_FAILURE(expect_as_defined(line, triangle, counts));
  }
  EXPECT_EQ(counts.meets, 20'000);
  EXPECT_GT(halfway, 2'000);
}

}  // namespace
}  // namespace pelt::test

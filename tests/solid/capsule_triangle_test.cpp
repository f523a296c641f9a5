#include "solid/region_triangle.hpp"

#include "exact/predicates.hpp"
#include "geometry/rational_distance.hpp"
#include "support/random.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace pelt::detail {
namespace {

using test::Random;
using test::RationalPoint;

/// Decides by exact distances.
TrianglePlace expected(const TriangleCorners& triangle, const Capsule& capsule) {
  const std::vector<RationalPoint> segment = {test::to_rational(capsule.a),
                                              test::to_rational(capsule.b)};
  const mpq_class radius(static_cast<double>(capsule.radius));
  std::vector<RationalPoint> corners;
  bool all_inside = true;
  for (const Vec3& corner : triangle) {
    corners.push_back(test::to_rational(corner));
    if (test::squared_distance({corners.back()}, segment) > radius * radius) all_inside = false;
  }
  if (all_inside) return TrianglePlace::inside;
  return test::squared_distance(corners, segment) <= radius * radius ? TrianglePlace::touching
                                                                     : TrianglePlace::apart;
}

/// Number of times that each answer occurred.
using Counts = std::array<int, 3>;

template <typename MakePoint, typename MakeRadius>
Counts expect_as_rationals(int cases, double sphere_chance, Random& random, const MakePoint& point,
                           const MakeRadius& radius) {
  Counts counts = {};
  for (int i = 0; i < cases; ++i) {
    TriangleCorners triangle = {point(), point(), point()};
    if (random.chance(0.1)) triangle[1] = triangle[0];
    Capsule capsule{point(), point(), radius()};
    if (random.chance(sphere_chance)) capsule.b = capsule.a;
    const TrianglePlace place = place_triangle(triangle, capsule);
    EXPECT_EQ(place, expected(triangle, capsule)) << "case " << i;
    ++counts[static_cast<std::size_t>(place)];
  }
  std::printf("apart %d, touching %d, inside %d\n", counts[0], counts[1], counts[2]);
  return counts;
}

void expect_all_kinds(const Counts& counts, int least) {
  for (const int count : counts) EXPECT_GT(count, least);
}

TEST(CapsuleTriangle, EqualsRationalsOnAGridWhereMuchTouches) {
  Random random(520);
  const auto point = [&] {
    const auto coordinate = [&] { return static_cast<float>(random.index(5)) - 2; };
    return Vec3{coordinate(), coordinate(), coordinate()};
  };
  const std::uint64_t before = exact_sign_count();
  expect_all_kinds(expect_as_rationals(3000, 0.3, random, point,
                                       [&] { return static_cast<float>(random.index(5)); }),
                   200);
  EXPECT_GT(exact_sign_count() - before, 500u);
}

TEST(CapsuleTriangle, EqualsRationalsInGeneralPosition) {
  Random random(521);
  expect_all_kinds(expect_as_rationals(
                       2000, 0.3, random, [&] { return random.point(1); },
                       [&] { return random.uniformf(0, 1.5); }),
                   100);
}

/// Coordinates so different in size that double cannot represent their differences.
TEST(CapsuleTriangle, EqualsRationalsOnAllScalesAtOnce) {
  Random random(522);
  const auto coordinate = [&] {
    return random.chance(0.2)
               ? 0.0f
               : std::ldexp(random.uniformf(-1, 1), static_cast<int>(random.index(120)) - 60);
  };
  expect_as_rationals(
      1500, 0.3, random,
      [&] {
        return Vec3{coordinate(), coordinate(), coordinate()};
      },
      [&] { return std::fabs(coordinate()); });
}

/// A radius that equals the distance to a vertex, edge or face, or is one float beside it.
TEST(CapsuleTriangle, DistinguishesTouchingFromJustNotTouching) {
  Random random(523);
  int touching = 0, apart = 0;
  for (int i = 0; i < 2000; ++i) {
    const TriangleCorners triangle = {random.point(1), random.point(1), random.point(1)};
    Capsule capsule{random.point(2), random.point(2), 0};
    if (random.chance(0.3)) capsule.b = capsule.a;
    const mpq_class squared =
        test::squared_distance({test::to_rational(triangle[0]), test::to_rational(triangle[1]),
                                test::to_rational(triangle[2])},
                               {test::to_rational(capsule.a), test::to_rational(capsule.b)});
    capsule.radius = static_cast<float>(std::sqrt(squared.get_d()));
    if (random.chance(0.3)) capsule.radius = std::nextafter(capsule.radius, 9.0f);
    const TrianglePlace place = place_triangle(triangle, capsule);
    ASSERT_EQ(place, expected(triangle, capsule)) << "case " << i;
    ++(place == TrianglePlace::apart ? apart : touching);
  }
  EXPECT_GT(touching, 400);
  EXPECT_GT(apart, 400);
}

/// 3-4-5 and 1-2-2-3 as integers, far out and small, so that squares need more than a double.
TEST(CapsuleTriangle, TouchesExactlyWherePythagorasSays) {
  const std::uint64_t before = exact_sign_count();
  for (const float unit : {0x1p-120f, 0x1p-20f, 1.0f, 5'592'405.0f * 0x1p30f}) {
    const Vec3 corner = {1 * unit, 2 * unit, 2 * unit};
    const TriangleCorners point = {corner, corner, corner};
    const float radius = 3 * unit;
    EXPECT_EQ(place_triangle(point, {{}, {}, radius}), TrianglePlace::inside);
    EXPECT_EQ(place_triangle(point, {{}, {}, std::nextafter(radius, 0.0f)}), TrianglePlace::apart);
  }
  EXPECT_GT(exact_sign_count(), before);
}

}  // namespace
}  // namespace pelt::detail

#include "exact/predicates.hpp"
#include "geometry/rational_distance.hpp"
#include "solid/region_triangle.hpp"
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

mpq_class side(const Face& face, const RationalPoint& p) {
  return test::dot(test::to_rational(face.normal),
                   test::difference(p, test::to_rational(face.origin))) -
         mpq_class(static_cast<double>(face.offset));
}

/// Clips a convex polygon at a face (Sutherland & Hodgman 1974).
std::vector<RationalPoint> cut(const std::vector<RationalPoint>& polygon, const Face& face) {
  std::vector<RationalPoint> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const RationalPoint &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    const mpq_class at_p = side(face, p), at_q = side(face, q);
    if (at_p <= 0) kept.push_back(p);
    if ((at_p < 0 && at_q > 0) || (at_p > 0 && at_q < 0)) {
      const mpq_class share = at_p / (at_p - at_q);
      RationalPoint crossing = p;
      for (std::size_t a = 0; a < 3; ++a) crossing[a] += share * (q[a] - p[a]);
      kept.push_back(crossing);
    }
  }
  return kept;
}

TrianglePlace expected(const TriangleCorners& triangle, const std::vector<Face>& faces) {
  std::vector<RationalPoint> polygon;
  bool is_inside = true;
  for (const Vec3& corner : triangle) {
    polygon.push_back(test::to_rational(corner));
    for (const Face& face : faces)
      if (side(face, polygon.back()) > 0) is_inside = false;
  }
  if (is_inside) return TrianglePlace::inside;
  for (const Face& face : faces) polygon = cut(polygon, face);
  return polygon.empty() ? TrianglePlace::apart : TrianglePlace::touching;
}

/// Tests 4,000 triangles against `face_count` random faces each.
template <typename MakePoint>
void expect_as_rationals(Random& random, std::uint32_t most_faces, int least,
                         const MakePoint& point) {
  std::array<int, 3> counts = {};
  for (int i = 0; i < 4000; ++i) {
    const TriangleCorners triangle = {point(), point(), point()};
    std::vector<Face> faces(1 + random.index(most_faces));
    for (Face& face : faces) face = {point(), point(), std::fabs(point().x)};
    const TrianglePlace place = place_triangle(triangle, faces);
    ASSERT_EQ(place, expected(triangle, faces)) << "case " << i;
    ++counts[static_cast<std::size_t>(place)];
  }
  std::printf("apart %d, touching %d, inside %d\n", counts[0], counts[1], counts[2]);
  for (const int count : counts) EXPECT_GE(count, least);
}

TEST(FacesTriangle, EqualsRationalsOnAGridWhereMuchTouches) {
  Random random(530);
  for (const std::uint32_t most_faces : {2u, 4u, 8u})
    expect_as_rationals(random, most_faces, 50, [&] {
      const auto coordinate = [&] { return static_cast<float>(random.index(5)) - 2; };
      return Vec3{coordinate(), coordinate(), coordinate()};
    });
}

TEST(FacesTriangle, EqualsRationalsInGeneralPosition) {
  Random random(531);
  for (const std::uint32_t most_faces : {3u, 6u, 12u})
    expect_as_rationals(random, most_faces, 50, [&] { return random.point(1); });
}

TEST(FacesTriangle, EqualsRationalsOnAllScalesAtOnce) {
  Random random(532);
  const auto coordinate = [&] {
    return std::ldexp(random.uniformf(-1, 1), static_cast<int>(random.index(120)) - 60);
  };
  expect_as_rationals(random, 5, 20, [&] {
    return Vec3{coordinate(), coordinate(), coordinate()};
  });
}

/// A triangle whose interior touches an edge or a vertex of a box whose coordinates are not round
/// in binary.
TEST(FacesTriangle, TouchesAtAnEdgeAndACornerOfABox) {
  const float c = 0.1f;
  const std::vector<Face> box = {{{1, 0, 0}, {}, c},  {{-1, 0, 0}, {}, c}, {{0, 1, 0}, {}, c},
                                 {{0, -1, 0}, {}, c}, {{0, 0, 1}, {}, c},  {{0, 0, -1}, {}, c}};
  const TriangleCorners over_edge = {Vec3{2 * c, 0, 0}, Vec3{0, 2 * c, 0}, Vec3{2 * c, 2 * c, 1}};
  EXPECT_EQ(place_triangle(over_edge, box), TrianglePlace::touching);
  const TriangleCorners over_corner = {Vec3{3 * c, 0, 0}, Vec3{0, 3 * c, 0}, Vec3{0, 0, 3 * c}};
  EXPECT_EQ(place_triangle(over_corner, box), expected(over_corner, box));
  const float beyond = std::nextafter(2 * c, 1.0f);
  const TriangleCorners past_edge = {Vec3{beyond, 0, 0}, Vec3{0, beyond, 0}, Vec3{2 * c, 2 * c, 1}};
  EXPECT_EQ(place_triangle(past_edge, box), TrianglePlace::apart);
}

TEST(FacesTriangle, NoFacesAreAllOfSpaceAndContradictingOnesNothing) {
  const TriangleCorners triangle = {Vec3{0, 0, 0}, Vec3{4, 0, 0}, Vec3{0, 4, 0}};
  EXPECT_EQ(place_triangle(triangle, std::span<const Face>()), TrianglePlace::inside);
  const Face nothing[] = {{{1, 0, 0}, {}, 1}, {{-1, 0, 0}, {}, -2}};
  EXPECT_EQ(place_triangle(triangle, nothing), TrianglePlace::apart);
  const Face nowhere[] = {{{0, 0, 0}, {}, -1}};
  EXPECT_EQ(place_triangle(triangle, nowhere), TrianglePlace::apart);
}

}  // namespace
}  // namespace pelt::detail

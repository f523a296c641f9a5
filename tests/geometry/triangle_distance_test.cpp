/// The scalar distance against rational numbers, on pairs that are designed to be hard, and the
/// wide distance against the scalar one.
#include "geometry/triangle_distance.hpp"

#include "distance_lanes.hpp"
#include "exact_distance.hpp"
#include "geometry/triage_lanes.hpp"
#include "support/instruction_sets.hpp"
#include "triangle_cases.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <random>
#include <vector>

namespace pelt::test {
namespace {

using detail::Barycentrics;
using detail::closest_on_triangle;
using detail::closest_points;
using detail::common_point;
using detail::point_at;
using detail::TriangleCorners;
using detail::triangles_intersect;
using detail::Vec3d;

/// The largest difference of two coordinates along an axis.
double extent(const std::vector<Vec3>& points) {
  double most = 0;
  for (const Vec3& p : points)
    for (const Vec3& q : points)
      most = std::max({most, std::abs(double{p.x} - q.x), std::abs(double{p.y} - q.y),
                       std::abs(double{p.z} - q.z)});
  return most;
}

double extent(const TriangleCorners& a, const TriangleCorners& b) {
  return extent({a[0], a[1], a[2], b[0], b[1], b[2]});
}

void expect_in_triangle(const Barycentrics& at) {
  for (const double share : at) EXPECT_GE(share, 0);
  EXPECT_NEAR(at[0] + at[1] + at[2], 1, 1e-15);
}

/// On all instruction sets, the wide distances equal the scalar one bit by bit.
void check_wide(const TriangleCorners& a, const TriangleCorners& b) {
  const std::array<TrianglePair, 8> pairs = turned(a, b);
  LaneDistances scalar_ones;
  for (std::size_t i = 0; i < 8; ++i)
    scalar_ones[i] = closest_points(pairs[i][0], pairs[i][1]).squared_distance;
  static LaneCorners lanes;
  fill(lanes, pairs);
  constexpr Compiled<DistanceLanes> kDistances[] = PELT_ALL_COMPILED(distance_lanes);
  ASSERT_EQ(on_each_compiled(kDistances, lanes), scalar_ones) << to_text(a) << to_text(b);
}

/// Counts over many pairs.
struct Tally {
  int apart = 0;
  double worst_error = 0;  ///< relative to the extent
};

void check(const TriangleCorners& a, const TriangleCorners& b, Tally& tally) {
  if (triangles_intersect(a, b)) return;
  ++tally.apart;
  const double size = extent(a, b), exact_distance = root(triangle_triangle(exact(a), exact(b)));
  const detail::ClosestPoints closest = closest_points(a, b);
  const double distance = std::sqrt(closest.squared_distance);
  tally.worst_error = std::max(tally.worst_error, std::abs(distance - exact_distance) / size);
  ASSERT_GT(distance, 0);
  ASSERT_LE(std::abs(distance - exact_distance), detail::kDistanceError * size)
      << to_text(a) << to_text(b);
  expect_in_triangle(closest.a);
  expect_in_triangle(closest.b);
  const Vec3d way = point_at(a, closest.a) - point_at(b, closest.b);
  ASSERT_NEAR(std::sqrt(squared_length(way)), distance, detail::kDistanceError * size);

  check_wide(a, b);
}

Tally check_many(IntegerPair (*make)(Random&), std::uint64_t seed, int pairs) {
  Random random(seed);
  Tally tally;
  for (int i = 0; i < pairs; ++i) {
    const IntegerPair pair = make(random);
    const int exponent = i % 3 == 0 ? -24 : i % 3 == 1 ? 30 : -110;
    check(scaled(pair.a, exponent), scaled(pair.b, exponent), tally);
    if (::testing::Test::HasFatalFailure()) break;
  }
  std::cout << "seed " << seed << ": " << tally.apart << " of " << pairs << " apart, worst error 2^"
            << std::log2(tally.worst_error) << " of the extent\n";
  return tally;
}

TEST(TriangleDistance, Anywhere) { EXPECT_GT(check_many(anywhere, 51, 2000).apart, 1000); }
TEST(TriangleDistance, OnGrid) { EXPECT_GT(check_many(on_grid, 52, 2000).apart, 500); }
TEST(TriangleDistance, InOnePlane) { EXPECT_GT(check_many(in_plane, 53, 2000).apart, 500); }
TEST(TriangleDistance, NearlyCoplanar) {
  EXPECT_GT(check_many(nearly_coplanar, 54, 2000).apart, 500);
}
TEST(TriangleDistance, ShearedGrid) { EXPECT_GT(check_many(sheared_grid, 55, 2000).apart, 500); }
TEST(TriangleDistance, Slivers) { EXPECT_GT(check_many(slivers, 56, 2000).apart, 500); }
TEST(TriangleDistance, Collapsed) { EXPECT_GT(check_many(collapsed, 57, 2000).apart, 500); }

/// The gap of two boxes on an axis.
double axis_gap(const TriangleCorners& a, const TriangleCorners& b, float Vec3::*axis) {
  const auto [low_a, high_a] = std::minmax({a[0].*axis, a[1].*axis, a[2].*axis});
  const auto [low_b, high_b] = std::minmax({b[0].*axis, b[1].*axis, b[2].*axis});
  return std::max({double{low_a} - high_b, double{low_b} - high_a, 0.0});
}

double squared_box_gap(const TriangleCorners& a, const TriangleCorners& b) {
  const double x = axis_gap(a, b, &Vec3::x), y = axis_gap(a, b, &Vec3::y);
  const double z = axis_gap(a, b, &Vec3::z);
  return x * x + y * y + z * z;
}

/// A corner of a sliver is so far that the sliver's computed normal says little about the height of
/// points over its near end.
TEST(TriangleDistance, SliversWithAFarCorner) {
  const TriangleCorners segment = {Vec3{1, -1, 3}, Vec3{0, 0, 0}, Vec3{1, -1, 3}};
  const TriangleCorners sliver = {Vec3{0x1.5d8684p+36f, -0x1.d208bp+32f, 0x1.36b076p+31f},
                                  Vec3{-3, 0x1.feae9p-17f, -1},
                                  Vec3{-0x1.9p+1f, -0x1.b4p+0f, 0x1.e8f5c2p+0f}};
  Tally tally;
  check(segment, sliver, tally);

  Random random(61);
  std::uniform_real_distribution<float> coordinate(-1, 1);
  for (int i = 0; i < 3000 && !HasFatalFailure(); ++i) {
    TriangleCorners pair[2];
    for (TriangleCorners& t : pair)
      for (Vec3& corner : t) corner = {coordinate(random), coordinate(random), coordinate(random)};
    const float length = std::ldexp(1.0f, static_cast<int>(random() % 50));
    Vec3& far = pair[random() % 2][random() % 3];
    far = {far.x * length, far.y * length, far.z * length};
    check(pair[0], pair[1], tally);
  }
  std::cout << "seed 61: " << tally.apart << " apart, worst error 2^"
            << std::log2(tally.worst_error) << " of the extent\n";
  EXPECT_GT(tally.apart, 1500);
}

/// The rounding errors of far corners are larger than the distance.
TEST(TriangleDistance, IsNeverLessThanThatOfTheBoxes) {
  const TriangleCorners from = {Vec3{-2, 0x1p58f, -3}, Vec3{-2, 0x1p29f, -0x1p58f},
                                Vec3{-0x1p58f, 0x1p58f, -0x1p58f}};
  const TriangleCorners to = {Vec3{0x1p29f, -0x1p58f, -0x1p58f}, Vec3{0, 0x1p29f, 1},
                              Vec3{2, 0x1p58f, 0}};
  EXPECT_NEAR(closest_points(from, to).squared_distance, 4, 1e-5);  // 2^-1022 without that limit

  Random random(60);
  const auto corner = [&] {
    constexpr float kFar[] = {0x1p58f, -0x1p58f, 0x1p29f};
    const auto coordinate = [&] {
      const std::uint32_t kind = static_cast<std::uint32_t>(random() % 6);
      return kind < 3 ? kFar[kind] : static_cast<float>(random() % 7) - 3;
    };
    const float x = coordinate(), y = coordinate(), z = coordinate();
    return Vec3{x, y, z};
  };
  Tally tally;
  int limited = 0;
  for (int i = 0; i < 3000; ++i) {
    const TriangleCorners a = {corner(), corner(), corner()}, b = {corner(), corner(), corner()};
    const double gap = squared_box_gap(a, b);
    if (gap == 0) continue;
    const double squared = closest_points(a, b).squared_distance;
    ASSERT_GE(squared, gap * (1 - 0x1p-19)) << to_text(a) << to_text(b);
    limited += squared < gap * (1 - 0x1p-21);
    check(a, b, tally);
  }
  EXPECT_GT(limited, 20);
}

TEST(TriangleDistance, PointsFromTriangles) {
  Random random(58);
  double worst = 0;
  for (int i = 0; i < 6000; ++i) {
    const IntegerPair pair = i % 3 == 0   ? anywhere(random)
                             : i % 3 == 1 ? slivers(random)
                                          : collapsed(random);
    const TriangleCorners t = scaled(pair.a, -20);
    const Vec3 p = scaled(pair.b, -20)[0];
    const double exact_distance = root(point_triangle(exact(p), exact(t)));
    const detail::ClosestOnTriangle closest = closest_on_triangle(Vec3d(p), t);
    const double size = extent({t[0], t[1], t[2], p});
    const double error = std::abs(std::sqrt(closest.squared_distance) - exact_distance);
    ASSERT_LE(error, detail::kDistanceError * size) << to_text(t);
    expect_in_triangle(closest.at);
    if (size > 0) worst = std::max(worst, error / size);
  }
  std::cout << "worst error 2^" << std::log2(worst) << " of the extent\n";
}

TEST(TriangleDistance, TouchingTrianglesHaveACommonPoint) {
  Random random(59);
  int touching = 0;
  for (int i = 0; i < 20000; ++i) {
    const IntegerPair pair = i % 2 ? anywhere(random) : on_grid(random);
    const TriangleCorners a = scaled(pair.a, -20), b = scaled(pair.b, -20);
    if (!triangles_intersect(a, b)) continue;
    ++touching;
    const detail::ClosestPoints common = common_point(a, b);
    expect_in_triangle(common.a);
    expect_in_triangle(common.b);
    const Vec3d way = point_at(a, common.a) - point_at(b, common.b);
    ASSERT_LE(std::sqrt(squared_length(way)), 0x1p-40 * extent(a, b)) << to_text(a) << to_text(b);
  }
  EXPECT_GT(touching, 2000);
}

}  // namespace
}  // namespace pelt::test

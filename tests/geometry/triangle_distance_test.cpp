/// The scalar distance and its certified float bound against rational numbers, on pairs that are
/// made to be hard.
#include "geometry/triangle_distance.hpp"

#include "apart_lanes.hpp"
#include "exact_distance.hpp"
#include "support/targets.hpp"
#include "triangle_cases.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <vector>

namespace pelt::test {
namespace {

using detail::Barycentrics;
using detail::common_point;
using detail::nearest_on_triangle;
using detail::nearest_points;
using detail::point_at;
using detail::TriangleCorners;
using detail::triangles_intersect;
using detail::Vec3d;

/// The largest difference of two coordinates on an axis.
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

LaneCorners& fill(LaneCorners& lanes, const std::array<TriangleCorners, 2>& pair) {
  for (int t = 0; t < 2; ++t)
    for (int corner = 0; corner < 3; ++corner)
      for (int lane = 0; lane < 8; ++lane) {
        const Vec3& p = pair[t][corner];
        const float xyz[4] = {p.x, p.y, p.z, 0};
        std::copy(xyz, xyz + 4, lanes[t][corner][lane]);
      }
  return lanes;
}

std::vector<LaneGaps> bounds_on_all_targets(const TriangleCorners& a, const TriangleCorners& b) {
  static LaneCorners lanes;
  fill(lanes, {a, b});
  std::vector<LaneGaps> bounds = {scalar::apart_lanes(lanes)};
  if (runs_here(Target::simd128)) bounds.push_back(simd128::apart_lanes(lanes));
  if (runs_here(Target::avx2)) bounds.push_back(avx2::apart_lanes(lanes));
  return bounds;
}

/// What came of many pairs.
struct Tally {
  int apart = 0, near_tight = 0;
  double worst_error = 0;  ///< relative to the extent
};

void check(const TriangleCorners& a, const TriangleCorners& b, Tally& tally) {
  if (triangles_intersect(a, b)) return;
  ++tally.apart;
  const double size = extent(a, b), exact_distance = root(triangle_triangle(exact(a), exact(b)));
  const detail::NearestPoints nearest = nearest_points(a, b);
  const double distance = std::sqrt(nearest.squared_distance);
  tally.worst_error = std::max(tally.worst_error, std::abs(distance - exact_distance) / size);
  ASSERT_GT(distance, 0);
  ASSERT_LE(std::abs(distance - exact_distance), detail::kDistanceError * size)
      << to_text(a) << to_text(b);
  expect_in_triangle(nearest.a);
  expect_in_triangle(nearest.b);
  const Vec3d way = point_at(a, nearest.a) - point_at(b, nearest.b);
  ASSERT_NEAR(std::sqrt(squared_length(way)), distance, detail::kDistanceError * size);

  const std::vector<LaneGaps> bounds = bounds_on_all_targets(a, b);
  for (const LaneGaps& bound : bounds) {
    ASSERT_EQ(std::memcmp(&bound, bounds.data(), sizeof bound), 0) << "same bits everywhere";
    ASSERT_FALSE(bound.at_least[0] > exact_distance * (1 + 0x1p-20)) << to_text(a) << to_text(b);
  }
  tally.near_tight += bounds[0].at_least[0] > 0.99 * exact_distance;
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
  std::cout << "seed " << seed << ": " << tally.apart << " of " << pairs << " apart, "
            << tally.near_tight << " bounds within 1 %, worst error 2^"
            << std::log2(tally.worst_error) << " of the extent\n";
  return tally;
}

TEST(TriangleDistance, Anywhere) {
  const Tally tally = check_many(anywhere, 51, 2000);
  EXPECT_GT(tally.apart, 1000);
  EXPECT_GT(tally.near_tight, tally.apart / 3) << "of the third that is neither huge nor tiny";
}
TEST(TriangleDistance, OnGrid) { EXPECT_GT(check_many(on_grid, 52, 2000).apart, 500); }
TEST(TriangleDistance, InOnePlane) { EXPECT_GT(check_many(in_plane, 53, 2000).apart, 500); }
TEST(TriangleDistance, NearlyCoplanar) {
  EXPECT_GT(check_many(nearly_coplanar, 54, 2000).apart, 500);
}
TEST(TriangleDistance, ShearedGrid) { EXPECT_GT(check_many(sheared_grid, 55, 2000).apart, 500); }
TEST(TriangleDistance, Slivers) { EXPECT_GT(check_many(slivers, 56, 2000).apart, 500); }
TEST(TriangleDistance, Collapsed) { EXPECT_GT(check_many(collapsed, 57, 2000).apart, 500); }

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
    const detail::NearestOnTriangle nearest = nearest_on_triangle(Vec3d(p), t);
    const double size = extent({t[0], t[1], t[2], p});
    const double error = std::abs(std::sqrt(nearest.squared_distance) - exact_distance);
    ASSERT_LE(error, detail::kDistanceError * size) << to_text(t);
    expect_in_triangle(nearest.at);
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
    const detail::NearestPoints common = common_point(a, b);
    expect_in_triangle(common.a);
    expect_in_triangle(common.b);
    const Vec3d way = point_at(a, common.a) - point_at(b, common.b);
    ASSERT_LE(std::sqrt(squared_length(way)), 0x1p-40 * extent(a, b)) << to_text(a) << to_text(b);
  }
  EXPECT_GT(touching, 2000);
}

}  // namespace
}  // namespace pelt::test

#include <pelt/distance.hpp>

#include "brute_distance.hpp"
#include "support/instruction_sets.hpp"

#include <gtest/gtest.h>

namespace pelt {
namespace {

using detail::closest_on_triangle;
using test::Limbs;
using test::Motion;
using test::posed_triangles;
using test::Random;
using test::Shape;
using test::TriangleCorners;

struct BrutePoint {
  double distance = std::numeric_limits<double>::infinity();
  std::uint32_t triangle = 0;
};

BrutePoint brute_point(const std::vector<TriangleCorners>& triangles, const Vec3& point) {
  BrutePoint best;
  double best_squared = best.distance;
  for (std::uint32_t i = 0; i < triangles.size(); ++i) {
    const double squared = closest_on_triangle(detail::Vec3d(point), triangles[i]).squared_distance;
    if (!(squared < best_squared)) continue;
    best_squared = squared;
    best = {std::sqrt(squared), i};
  }
  return best;
}

void expect_equal(const ClosestPoint& found, const BrutePoint& expected) {
  ASSERT_EQ(found.distance, expected.distance);
  ASSERT_EQ(found.point.triangle, expected.triangle);
}

TEST(ClosestPoint, EqualsBruteForceOnBendingLimbs) {
  Random random(130);
  Limbs limbs;
  for (int round = 0; round < 40; ++round) {
    limbs.move(random, 0);
    const auto triangles = limbs.triangles_a();
    for (int i = 0; i < 20; ++i) {
      Vec3 point = random.point(i % 2 ? 1 : 20);
      if (i % 5 == 0) point = triangles[random.index(100)][i % 3];
      ClosestPoint closest;
      closest_point(limbs.a, point, limbs.scratch, closest);
      expect_equal(closest, brute_point(triangles, point));
      ASSERT_FALSE(HasFatalFailure());
      if (i % 5 == 0) {
        EXPECT_EQ(closest.distance, 0);
      }
      const auto way = detail::Vec3d(closest.point.position) - detail::Vec3d(point);
      EXPECT_NEAR(std::sqrt(squared_length(way)), closest.distance, 2e-6);
    }
  }
}

TEST(ClosestPoint, EqualsBruteForceOnSoupsUnderAnyAffineJoints) {
  Random random(131);
  Scratch scratch;
  for (const Motion motion : {Motion::rigid, Motion::affine, Motion::collapsed, Motion::far_away})
    for (int round = 0; round < 10; ++round) {
      const Shape soup = test::make_soup(random, 150, 6, 4, test::Weights::random);
      Pose pose(*build_model(soup.view()));
      ASSERT_TRUE(pose.set_palette(test::make_palette(random, 6, motion, 1)));
      const auto triangles = posed_triangles(soup.triangles, pose);
      for (int i = 0; i < 20; ++i) {
        const Vec3 point = i % 4 ? random.point(3) : triangles[i][0];
        ClosestPoint closest;
        closest_point(pose, point, scratch, closest);
        expect_equal(closest, brute_point(triangles, point));
        ASSERT_FALSE(HasFatalFailure());
      }
    }
}

TEST(ClosestPoint, BeyondTheMaximumNothingIsFound) {
  Random random(132);
  Limbs limbs;
  limbs.move(random, 0);
  for (int i = 0; i < 50; ++i) {
    const Vec3 point = random.point(4);
    ClosestPoint exact, closest;
    closest_point(limbs.a, point, limbs.scratch, exact);
    closest_point(limbs.a, point, limbs.scratch, closest, {.max_distance = exact.distance});
    EXPECT_EQ(closest.distance, exact.distance);
    EXPECT_EQ(closest.point.triangle, exact.point.triangle);
    closest_point(limbs.a, point, limbs.scratch, closest,
                  {.max_distance = std::nextafter(exact.distance, 0)});
    EXPECT_FALSE(closest);
  }
}

TEST(ClosestPoint, ABatchGivesTheSameOnAllInstructionSets) {
  Random random(133);
  Limbs limbs;
  std::vector<Vec3> points;
  for (int i = 0; i < 50; ++i) points.push_back(random.point(2));
  std::vector<std::vector<ClosestPoint>> answers;
  test::on_each_instruction_set([&](InstructionSet) {
    Random again(134);
    limbs.move(again, 0);
    auto& closest = answers.emplace_back(points.size());
    closest_points(limbs.a, points, limbs.scratch, closest);
  });
  for (const auto& closest : answers)
    for (std::size_t i = 0; i < points.size(); ++i) {
      ClosestPoint one;
      closest_point(limbs.a, points[i], limbs.scratch, one);
      EXPECT_EQ(closest[i].distance, one.distance);
      EXPECT_EQ(closest[i].point.triangle, one.point.triangle);
      EXPECT_EQ(closest[i].point.position, one.point.position);
    }
}

TEST(ClosestPoint, OpensFewNodes) {
  const Shape limb = test::make_limb(200, 40, 5);
  Pose pose(*build_model(limb.view()));
  Scratch scratch;
  ClosestPoint closest;
  const QueryStats stats = closest_point(pose, {0.3f, 0.4f, 0}, scratch, closest);
  EXPECT_TRUE(closest);
  EXPECT_LT(stats.posed_vertices, limb.rest_positions.size() / 4);
  EXPECT_LT(stats.triangle_pairs, 200u);
}

}  // namespace
}  // namespace pelt

/// Sections 4 and 4.1 of Kavan & Zara 2005: equations 2 to 5 and the paper's statements about them.

#include "balls.hpp"
#include "random_weights.hpp"

#include <gtest/gtest.h>

namespace pelt::paper {
namespace {

using test::Ball;
using test::Random;
using test::Vec3d;

constexpr int kCases = 2000;
constexpr int kDirections = 100;
constexpr double kTolerance = 1e-8;  // n kWeightTolerance and the rounding of doubles

std::vector<WeightInterval> whole_intervals(std::size_t count) {
  return std::vector<WeightInterval>(count, WeightInterval{0, 1});
}

/// Spheres of one radius, as after rotations, none inside the hull of the others.
std::vector<Ball> balls_in_convex_position(Random& random, std::size_t count) {
  const double radius = random.unit();
  std::vector<Ball> balls;
  for (std::size_t j = 0; j < count; ++j)
    balls.push_back({3 * test::random_direction(random), radius});
  return balls;
}

TEST(Equation2, EveryPosedVertexLiesInTheHullOfItsImages) {
  Random random(1);
  for (int i = 0; i < kCases; ++i) {
    std::vector<Ball> images(1 + random.index(6));
    for (Ball& image : images) image.centre = Vec3d(random.point(1));
    const auto weights = test::random_weights(random, images.size());
    const Vec3d posed = test::blend(weights, images).centre;  // eq. 1
    for (int k = 0; k < kDirections; ++k) {
      const Vec3d m = test::random_direction(random);
      ASSERT_LE(detail::dot(m, posed), test::hull_support(images, m) + kTolerance);
    }
  }
}

TEST(Equation3, WithoutIntervalsTheGeneralisedHullIsTheConvexHull) {
  Random random(2);
  for (int i = 0; i < kCases; ++i) {
    const std::vector<Ball> balls = test::random_balls(random, 1 + random.index(8));
    const auto intervals = whole_intervals(balls.size());
    ASSERT_EQ(test::corner_balls(intervals, balls).size(), balls.size());
    for (int k = 0; k < kDirections; ++k) {
      const Vec3d m = test::random_direction(random);
      ASSERT_NEAR(test::generalised_hull_support(intervals, balls, m), test::hull_support(balls, m),
                  kTolerance);
    }
  }
}

TEST(Equation5, TheHullOfTheCornerSpheresIsTheGeneralisedHull) {
  Random random(3);
  for (int i = 0; i < kCases; ++i) {
    const std::vector<Ball> balls = test::random_balls(random, 1 + random.index(8));
    const auto intervals = test::random_intervals(random, balls.size());
    const std::vector<Ball> corners = test::corner_balls(intervals, balls);
    for (int k = 0; k < kDirections; ++k) {
      const Vec3d m = test::random_direction(random);
      ASSERT_NEAR(test::hull_support(corners, m),
                  test::generalised_hull_support(intervals, balls, m), kTolerance);
    }
  }
}

TEST(Equation4, TheGeneralisedHullHasTheSpheresOfAllWeightsWithinTheIntervals) {
  Random random(4);
  int near_boundary = 0;
  for (int i = 0; i < kCases; ++i) {
    const std::vector<Ball> balls = test::random_balls(random, 1 + random.index(8));
    const auto intervals = test::random_intervals(random, balls.size());
    const std::vector<Ball> corners = test::corner_balls(intervals, balls);
    for (int k = 0; k < kDirections; ++k) {
      const Ball ball = test::blend(test::random_weights_within(random, intervals), balls);
      const Vec3d m = test::random_direction(random);
      const double limit = test::hull_support(corners, m);
      ASSERT_LE(test::support(ball, m), limit + kTolerance);
      near_boundary += test::support(ball, m) > limit - 0.01;
    }
  }
  EXPECT_GT(near_boundary, kCases * kDirections / 10);
}

TEST(GeneralisedHull, LiesInTheConvexHull) {
  Random random(5);
  int smaller = 0;
  for (int i = 0; i < kCases; ++i) {
    const std::vector<Ball> balls = test::random_balls(random, 1 + random.index(8));
    const std::vector<Ball> corners =
        test::corner_balls(test::random_intervals(random, balls.size()), balls);
    for (int k = 0; k < kDirections; ++k) {
      const Vec3d m = test::random_direction(random);
      ASSERT_LE(test::hull_support(corners, m), test::hull_support(balls, m) + kTolerance);
      smaller += test::hull_support(corners, m) < test::hull_support(balls, m) - 0.01;
    }
  }
  EXPECT_GT(smaller, kCases * kDirections / 2);
}

/// The largest difference between the two hulls, over the directions from the middle to the sphere
/// of one joint.
double largest_gap(std::span<const WeightInterval> intervals, std::span<const Ball> balls) {
  double gap = 0;
  for (const Ball& ball : balls)
    gap = std::max(gap, test::hull_support(balls, ball.centre) -
                            test::generalised_hull_support(intervals, balls, ball.centre));
  return gap;
}

TEST(GeneralisedHull, EqualsTheConvexHullOnlyIfAllIntervalsAreWhole) {
  Random random(6);
  for (int i = 0; i < kCases; ++i) {
    const std::vector<Ball> balls = balls_in_convex_position(random, 2 + random.index(7));
    ASSERT_LT(largest_gap(whole_intervals(balls.size()), balls), kTolerance);
    auto intervals = whole_intervals(balls.size());
    intervals[random.index(static_cast<std::uint32_t>(balls.size()))].high = 0.9;
    ASSERT_GT(largest_gap(intervals, balls), 1e-4);
    intervals = whole_intervals(balls.size());
    intervals[random.index(static_cast<std::uint32_t>(balls.size()))].low = 0.1;
    ASSERT_GT(largest_gap(intervals, balls), 1e-4);
  }
}

TEST(GeneralisedHull, EqualsTheConvexHullAlsoIfTheIntervalIsOfASphereInsideTheHullOfTheOthers) {
  // "Equal iff all weight intervals are <0, 1>" assumes that every sphere contributes to the hull.
  const std::vector<Ball> balls = {{{-1, 0, 0}, 1}, {{1, 0, 0}, 1}, {{0.2, 0, 0}, 0.5}};
  const std::vector<WeightInterval> intervals = {{0, 1}, {0, 1}, {0, 0.1}};
  Random random(7);
  for (int k = 0; k < kDirections; ++k) {
    const Vec3d m = test::random_direction(random);
    ASSERT_NEAR(test::generalised_hull_support(intervals, balls, m), test::hull_support(balls, m),
                kTolerance);
  }
}

}  // namespace
}  // namespace pelt::paper

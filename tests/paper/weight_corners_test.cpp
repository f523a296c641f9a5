#include "paper/weight_corners.hpp"

#include "balls.hpp"
#include "random_weights.hpp"

#include <gtest/gtest.h>

namespace pelt::paper {
namespace {

using test::Random;
using Intervals = std::vector<WeightInterval>;
using Corner = std::vector<double>;

constexpr double kTolerance = 1e-8;

std::vector<Corner> corners_of(const Intervals& intervals) {
  std::vector<double> numbers;
  append_weight_corners(intervals, numbers);
  EXPECT_EQ(numbers.size() % intervals.size(), 0u);
  std::vector<Corner> corners;
  for (auto at = numbers.begin(); at != numbers.end(); at += static_cast<long>(intervals.size()))
    corners.emplace_back(at, at + static_cast<long>(intervals.size()));
  return corners;
}

double dot(const Corner& w, const std::vector<double>& q) {
  return std::inner_product(w.begin(), w.end(), q.begin(), 0.0);
}

double largest_over_corners(const std::vector<Corner>& corners, const std::vector<double>& q) {
  double largest = dot(corners[0], q);
  for (const Corner& corner : corners) largest = std::max(largest, dot(corner, q));
  return largest;
}

std::vector<double> random_objective(Random& random, std::size_t count) {
  std::vector<double> q(count);
  for (double& entry : q) entry = random.uniform(-1, 1);
  return q;
}

bool sums_to_one(const Corner& corner) {
  return std::fabs(std::accumulate(corner.begin(), corner.end(), 0.0) - 1) <= 1e-12;
}

bool lies_within(const Corner& corner, const Intervals& intervals) {
  for (std::size_t j = 0; j < corner.size(); ++j)
    if (corner[j] < intervals[j].low - kWeightTolerance ||
        corner[j] > intervals[j].high + kWeightTolerance)
      return false;
  return true;
}

bool are_distinct(const std::vector<Corner>& corners) {
  for (std::size_t a = 0; a < corners.size(); ++a)
    for (std::size_t b = 0; b < a; ++b) {
      double difference = 0;
      for (std::size_t j = 0; j < corners[a].size(); ++j)
        difference = std::max(difference, std::fabs(corners[a][j] - corners[b][j]));
      if (difference <= kWeightTolerance) return false;
    }
  return true;
}

std::size_t most_corners(std::size_t joint_count) {
  constexpr std::array<std::size_t, 9> kMax = {0, 1, 2, 6, 12, 30, 60, 140, 280};
  return kMax[joint_count];
}

TEST(WeightCorners, AreInsideDistinctAndFew) {
  Random random(1);
  for (int i = 0; i < 3000; ++i) {
    const auto intervals = test::random_intervals(random, 1 + random.index(8));
    const std::vector<Corner> corners = corners_of(intervals);
    ASSERT_GE(corners.size(), 1u);
    ASSERT_LE(corners.size(), most_corners(intervals.size()));
    ASSERT_TRUE(are_distinct(corners));
    for (const Corner& corner : corners) {
      ASSERT_TRUE(sums_to_one(corner));
      ASSERT_TRUE(lies_within(corner, intervals));
    }
  }
}

TEST(WeightCorners, MostAreReached) {
  // n intervals <0, h> with 1 halfway between two multiples of h: the plane cuts through the middle
  // of the box.
  for (const auto& [count, high] : std::vector<std::pair<std::size_t, double>>{
           {1, 1}, {2, 2.0 / 3}, {3, 2.0 / 3}, {4, 2.0 / 3}, {8, 2.0 / 7}})
    EXPECT_EQ(corners_of(Intervals(count, {0, high})).size(), most_corners(count)) << count;
}

TEST(WeightCorners, SpanTheClippedSimplex) {
  Random random(2);
  int clipped = 0;
  constexpr int kCases = 2000;
  for (int i = 0; i < kCases; ++i) {
    const auto intervals = test::random_intervals(random, 1 + random.index(8));
    const std::vector<Corner> corners = corners_of(intervals);
    clipped += corners.size() > intervals.size();
    for (int k = 0; k < 30; ++k) {
      const auto q = random_objective(random, intervals.size());
      const double largest = largest_over_corners(corners, q);
      ASSERT_NEAR(largest, test::largest_over_weights(intervals, q), kTolerance);
      const auto w = test::random_weights_within(random, intervals);
      ASSERT_TRUE(lies_within(w, intervals) && sums_to_one(w));
      ASSERT_LE(dot(w, q), largest + kTolerance);
    }
  }
  EXPECT_GT(clipped, kCases / 3);
}

TEST(WeightCorners, OneVertexHasOneCornerAlsoIfItsSumIsOffByRounding) {
  Random random(3);
  for (int i = 0; i < 3000; ++i) {
    auto weights = test::random_weights(random, 1 + random.index(8));
    const std::size_t off = random.index(static_cast<std::uint32_t>(weights.size()));
    weights[off] += random.uniform(-0.9, 0.9) * kWeightTolerance;
    Intervals intervals;
    for (const double weight : weights) intervals.push_back({weight, weight});
    const std::vector<Corner> corners = corners_of(intervals);
    ASSERT_EQ(corners.size(), 1u);
    for (std::size_t j = 0; j < weights.size(); ++j)
      ASSERT_NEAR(corners[0][j], weights[j], kWeightTolerance);
  }
}

TEST(WeightCorners, AFixedWeightDoublesNoCorner) {
  EXPECT_EQ(corners_of({{0.2, 0.2}, {0, 1}, {0, 1}}).size(), 2u);
  EXPECT_EQ(corners_of({{0.2, 0.2}, {0.3, 0.3}, {0.1, 0.6}}).size(), 1u);
  EXPECT_EQ(corners_of({{0.4, 0.6}, {0.4, 0.6}}).size(), 2u);
  EXPECT_EQ(corners_of({{1, 1}}).size(), 1u);
}

TEST(WeightCorners, CornersThatFallTogetherAreTakenOnce) {
  // If the first weight is exactly one half, the second is exactly at its upper end, and so on.
  EXPECT_EQ(corners_of({{0, 0.5}, {0, 0.5}, {0, 0.5}}).size(), 3u);
  EXPECT_EQ(corners_of({{0, 0.25}, {0, 0.25}, {0, 0.25}, {0, 0.25}}).size(), 1u);
  EXPECT_EQ(corners_of(Intervals(8, {0, 1})).size(), 8u);
}

TEST(WeightCorners, IntervalsAsThinAsRoundingLoseNothing) {
  Random random(4);
  for (int i = 0; i < 1000; ++i) {
    const auto w = test::random_weights(random, 2 + random.index(7));
    Intervals intervals;
    for (const double weight : w)
      intervals.push_back({weight - random.unit() * 1e-9, weight + random.unit() * 1e-9});
    const std::vector<Corner> corners = corners_of(intervals);
    const auto q = random_objective(random, w.size());
    ASSERT_NEAR(largest_over_corners(corners, q), dot(w, q), 1e-7);
  }
}

TEST(WeightCorners, ManyJointsGetTheCornersOfASimplexAroundTheClippedOne) {
  Random random(5);
  for (int i = 0; i < 1000; ++i) {
    const auto intervals =
        test::random_intervals(random, kMaxEnumeratedJoints + 1 + random.index(8));
    const std::vector<Corner> corners = corners_of(intervals);
    ASSERT_EQ(corners.size(), intervals.size());
    for (const Corner& corner : corners) {
      ASSERT_TRUE(sums_to_one(corner));
      for (std::size_t j = 0; j < corner.size(); ++j)
        ASSERT_GE(corner[j], intervals[j].low - kWeightTolerance);
    }
    for (int k = 0; k < 30; ++k) {
      const auto q = random_objective(random, intervals.size());
      ASSERT_GE(largest_over_corners(corners, q),
                test::largest_over_weights(intervals, q) - kTolerance);
    }
  }
}

TEST(WeightCorners, AreAppended) {
  std::vector<double> corners = {7};
  append_weight_corners(Intervals{{0, 1}, {0, 1}}, corners);
  ASSERT_EQ(corners.size(), 5u);
  EXPECT_EQ(corners[0], 7);
}

}  // namespace
}  // namespace pelt::paper

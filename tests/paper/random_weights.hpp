#pragma once

/// Random convex weights and weight intervals.

#include "paper/weight_corners.hpp"
#include "support/random.hpp"

#include <algorithm>
#include <numeric>
#include <span>
#include <vector>

namespace pelt::test {

/// A point of W_n; about a fifth of the weights are zero.
inline std::vector<double> random_weights(Random& random, std::size_t count) {
  std::vector<double> weights(count, 0);
  double sum = 0;
  while (sum == 0) {
    for (double& weight : weights) weight = random.chance(0.2) ? 0 : random.unit();
    sum = std::accumulate(weights.begin(), weights.end(), 0.0);
  }
  for (double& weight : weights) weight /= sum;
  return weights;
}

/// The smallest intervals <l_j, h_j> that contain the weights of a set of vertices.
inline std::vector<paper::WeightInterval> intervals_of(
    std::span<const std::vector<double>> vertices) {
  std::vector<paper::WeightInterval> intervals(vertices[0].size());
  for (const std::vector<double>& weights : vertices)
    for (std::size_t j = 0; j < weights.size(); ++j) intervals[j].include(weights[j]);
  return intervals;
}

/// The intervals of one to five random vertices.
inline std::vector<paper::WeightInterval> random_intervals(Random& random, std::size_t count) {
  std::vector<std::vector<double>> vertices(1 + random.index(5));
  for (std::vector<double>& weights : vertices) weights = random_weights(random, count);
  return intervals_of(vertices);
}

/// A random point of W': starting from w = l, distributes the rest of 1 over random joints.
inline std::vector<double> random_weights_within(Random& random,
                                                 std::span<const paper::WeightInterval> intervals) {
  std::vector<double> weights;
  double left = 1;
  for (const paper::WeightInterval& interval : intervals) {
    weights.push_back(interval.low);
    left -= interval.low;
  }
  const auto count = static_cast<std::uint32_t>(intervals.size());
  const auto give = [&](std::size_t j, double share) {
    const double part = std::max(0.0, std::min(share * left, intervals[j].high - weights[j]));
    weights[j] += part;
    left -= part;
  };
  for (std::uint32_t i = 0; i < 2 * count; ++i) give(random.index(count), random.unit());
  const std::uint32_t first = random.index(count);
  for (std::uint32_t i = 0; i < count; ++i) give((first + i) % count, 1);
  return weights;
}

}  // namespace pelt::test

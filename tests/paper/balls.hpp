#pragma once

/// Balls in double precision, and the hulls of section 4.1 and Appendix A, represented by their
/// support functions h(m) = max over the set of m.x. A closed convex set contains another if and
/// only if its support function is nowhere smaller.

#include "base/vec3.hpp"
#include "paper/weight_corners.hpp"
#include "support/random.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>
#include <vector>

namespace pelt::test {

using detail::Vec3d;

inline double length(const Vec3d& v) { return std::sqrt(detail::squared_length(v)); }

struct Ball {
  Vec3d centre;
  double radius = 0;
};

inline double support(const Ball& ball, const Vec3d& m) {
  return detail::dot(m, ball.centre) + length(m) * ball.radius;
}

/// sum_j w_j S_j, which is a ball by Lemma 1.
inline Ball blend(std::span<const double> weights, std::span<const Ball> balls) {
  Ball sum;
  for (std::size_t j = 0; j < balls.size(); ++j) {
    sum.centre = sum.centre + weights[j] * balls[j].centre;
    sum.radius += weights[j] * balls[j].radius;
  }
  return sum;
}

/// h of CH(S_1 u ... u S_n), eq. 2.
inline double hull_support(std::span<const Ball> balls, const Vec3d& m) {
  double largest = support(balls[0], m);
  for (const Ball& ball : balls) largest = std::max(largest, support(ball, m));
  return largest;
}

/// The largest w.q over W'. No corners are needed: starting from w = l, the rest of 1 goes to the
/// largest q first, as much as its interval allows.
inline double largest_over_weights(std::span<const paper::WeightInterval> intervals,
                                   std::span<const double> q) {
  std::vector<std::size_t> order(q.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return q[a] > q[b]; });
  double sum = 0, left = 1;
  for (std::size_t j = 0; j < q.size(); ++j) {
    sum += intervals[j].low * q[j];
    left -= intervals[j].low;
  }
  for (const std::size_t j : order) {
    const double taken = std::clamp(left, 0.0, intervals[j].high - intervals[j].low);
    sum += taken * q[j];
    left -= taken;
  }
  return sum;
}

/// h of M', the generalised convex hull of eq. 4: a union's support is the largest of its parts',
/// and that of sum_j w_j S_j is sum_j w_j h_Sj.
inline double generalised_hull_support(std::span<const paper::WeightInterval> intervals,
                                       std::span<const Ball> balls, const Vec3d& m) {
  std::vector<double> q;
  for (const Ball& ball : balls) q.push_back(support(ball, m));
  return largest_over_weights(intervals, q);
}

/// R_1 ... R_m of eq. 5.
inline std::vector<Ball> corner_balls(std::span<const paper::WeightInterval> intervals,
                                      std::span<const Ball> balls) {
  std::vector<double> corners;
  paper::append_weight_corners(intervals, corners);
  std::vector<Ball> blended;
  for (std::size_t c = 0; c < corners.size(); c += balls.size())
    blended.push_back(blend({corners.data() + c, balls.size()}, balls));
  return blended;
}

/// A random direction of length 1.
inline Vec3d random_direction(Random& random) {
  for (;;) {
    const Vec3d v(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    const double size = length(v);
    if (size > 0.1 && size < 1) return (1 / size) * v;
  }
}

/// Balls in a box of half size 1; every third ball is a point.
inline std::vector<Ball> random_balls(Random& random, std::size_t count) {
  std::vector<Ball> balls;
  for (std::size_t j = 0; j < count; ++j)
    balls.push_back({Vec3d(random.point(1)), random.chance(1.0 / 3) ? 0 : random.unit()});
  return balls;
}

}  // namespace pelt::test

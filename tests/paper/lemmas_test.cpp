/// Appendix A of Kavan & Zara 2005, in one to four dimensions. M is the union of sum_j w_j S_j over
/// all convex weights w.

#include "random_weights.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace pelt::paper {
namespace {

using test::Random;
using test::random_weights;

constexpr int kCases = 20000;
constexpr double kTolerance = 1e-12;

using Point = std::vector<double>;

struct Ball {
  Point centre;
  double radius = 0;
};

Point sum_of(const std::vector<double>& weights, const std::vector<Point>& points) {
  Point sum(points[0].size(), 0);
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t a = 0; a < sum.size(); ++a) sum[a] += weights[i] * points[i][a];
  return sum;
}

double dot(const Point& x, const Point& y) {
  double sum = 0;
  for (std::size_t a = 0; a < x.size(); ++a) sum += x[a] * y[a];
  return sum;
}

double distance(const Point& x, const Point& y) {
  const Point d = sum_of({1, -1}, {x, y});
  return std::sqrt(dot(d, d));
}

bool contains(const Ball& ball, const Point& x) {
  return distance(x, ball.centre) <= ball.radius + kTolerance;
}

/// The sphere of Lemma 1.
Ball blend(const std::vector<double>& weights, const std::vector<Ball>& balls) {
  Ball sum{Point(balls[0].centre.size(), 0), 0};
  for (std::size_t i = 0; i < balls.size(); ++i) {
    sum.centre = sum_of({1, weights[i]}, {sum.centre, balls[i].centre});
    sum.radius += weights[i] * balls[i].radius;
  }
  return sum;
}

Point random_point(Random& random, std::size_t dimensions) {
  Point x(dimensions);
  for (double& coordinate : x) coordinate = random.uniform(-1, 1);
  return x;
}

/// Half of the points are on the boundary.
Point random_point_in(Random& random, const Ball& ball) {
  Point towards = random_point(random, ball.centre.size());
  while (dot(towards, towards) == 0) towards = random_point(random, ball.centre.size());
  const double reach = ball.radius * (random.chance(0.5) ? 1 : random.unit());
  return sum_of({1, reach / std::sqrt(dot(towards, towards))}, {ball.centre, towards});
}

enum class Radii { positive, some_zero, all_zero };

std::vector<Ball> random_balls(Random& random, Radii radii) {
  const std::size_t dimensions = 1 + random.index(4), count = 1 + random.index(6);
  std::vector<Ball> balls;
  for (std::size_t j = 0; j < count; ++j) {
    const bool zero = radii == Radii::all_zero || (radii == Radii::some_zero && random.chance(0.5));
    balls.push_back({random_point(random, dimensions), zero ? 0 : random.uniform(0.01, 1)});
  }
  return balls;
}

Radii radii_of_case(int i) { return static_cast<Radii>(i % 3); }

TEST(Lemma1, ConvexCombinationsOfPointsOfTheSpheresLieInTheBlendedSphere) {
  Random random(1);
  int on_boundary = 0;
  for (int i = 0; i < kCases; ++i) {
    const std::vector<Ball> balls = random_balls(random, radii_of_case(i));
    const std::vector<double> w = random_weights(random, balls.size());
    std::vector<Point> x;
    for (const Ball& ball : balls) x.push_back(random_point_in(random, ball));
    const Ball blended = blend(w, balls);
    const Point sum = sum_of(w, x);
    ASSERT_TRUE(contains(blended, sum));
    on_boundary += !contains({blended.centre, blended.radius - 1e-6}, sum);
  }
  EXPECT_GT(on_boundary, kCases / 10);  // the lemma's radius is not larger than necessary
}

/// The points x_i of the paper's proof. The proof divides by r, which is 0 if every sphere with a
/// weight is a point; x is then the centre, and x_i = c_i.
Point point_of_proof(const Point& x, const Ball& blended, const Ball& ball) {
  if (blended.radius == 0) return ball.centre;
  const double scale = ball.radius / blended.radius;
  return sum_of({scale, -scale, 1}, {x, blended.centre, ball.centre});
}

TEST(Lemma1, EveryPointOfTheBlendedSphereIsAConvexCombination) {
  Random random(2);
  int zero_radii = 0;
  for (int i = 0; i < kCases; ++i) {
    const std::vector<Ball> balls = random_balls(random, radii_of_case(i));
    const std::vector<double> w = random_weights(random, balls.size());
    const Ball blended = blend(w, balls);
    const Point x = random_point_in(random, blended);
    std::vector<Point> parts;
    for (const Ball& ball : balls) {
      parts.push_back(point_of_proof(x, blended, ball));
      ASSERT_TRUE(contains(ball, parts.back()));
    }
    ASSERT_LE(distance(sum_of(w, parts), x), kTolerance);
    zero_radii += blended.radius == 0;
  }
  EXPECT_GT(zero_radii, kCases / 4);
}

TEST(Lemma2, TheUnionOfAllBlendedSpheresIsConvex) {
  Random random(3);
  int outside_both = 0;
  for (int i = 0; i < kCases; ++i) {
    const std::vector<Ball> balls = random_balls(random, radii_of_case(i));
    const std::vector<double> w = random_weights(random, balls.size());
    const std::vector<double> w1 = random_weights(random, balls.size());
    const Point x = random_point_in(random, blend(w, balls));
    const Point x1 = random_point_in(random, blend(w1, balls));
    const double lambda = random.unit();
    const Point between = sum_of({1 - lambda, lambda}, {x, x1});
    ASSERT_TRUE(contains(blend(sum_of({1 - lambda, lambda}, {w, w1}), balls), between));
    outside_both += !contains(blend(w, balls), between) && !contains(blend(w1, balls), between);
  }
  EXPECT_GT(outside_both, kCases / 4);  // the point needed other weights
}

TEST(Lemma3, TheUnionOfAllBlendedSpheresLiesInTheConvexHull) {
  Random random(4);
  int near_boundary = 0;
  for (int i = 0; i < kCases; ++i) {
    const std::vector<Ball> balls = random_balls(random, radii_of_case(i));
    const std::vector<double> w = random_weights(random, balls.size());
    const Point x = random_point_in(random, blend(w, balls));
    // All half-spaces that contain the spheres also contain the point.
    for (int k = 0; k < 10; ++k) {
      const Point m = random_point(random, x.size());
      double support = dot(m, balls[0].centre);
      for (const Ball& ball : balls)
        support = std::max(support, dot(m, ball.centre) + ball.radius * std::sqrt(dot(m, m)));
      ASSERT_LE(dot(m, x), support + kTolerance);
      near_boundary += dot(m, x) > support - 0.01;
    }
  }
  EXPECT_GT(near_boundary, kCases / 10);
}

TEST(Lemma3, TheConvexHullLiesInTheUnionOfAllBlendedSpheres) {
  Random random(5);
  int outside_all = 0;
  for (int i = 0; i < kCases; ++i) {
    const std::vector<Ball> balls = random_balls(random, radii_of_case(i));
    // An arbitrary point of the hull: a convex combination of points of the spheres, several per
    // sphere.
    const std::vector<double> u = random_weights(random, 1 + random.index(8));
    std::vector<Point> points;
    std::vector<double> w(balls.size(), 0);
    for (const double coefficient : u) {
      const std::size_t j = random.index(static_cast<std::uint32_t>(balls.size()));
      points.push_back(random_point_in(random, balls[j]));
      w[j] += coefficient;
    }
    const Point x = sum_of(u, points);
    ASSERT_TRUE(contains(blend(w, balls), x));
    bool in_one = false;
    for (const Ball& ball : balls) in_one = in_one || contains(ball, x);
    outside_all += !in_one;
  }
  EXPECT_GT(outside_all, kCases / 4);
}

}  // namespace
}  // namespace pelt::paper

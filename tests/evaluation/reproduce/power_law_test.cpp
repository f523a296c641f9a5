#include "evaluation/reproduce/growth.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace pelt::reproduce {
namespace {

std::vector<Measured> power(double factor, double exponent) {
  std::vector<Measured> points;
  for (const double size : {1.0, 3.0, 10.0, 250.0, 1e6})
    points.push_back({size, factor * std::pow(size, exponent)});
  return points;
}

TEST(FittedExponent, IsThatOfAnExactPower) {
  for (const double exponent : {-1.0, 0.0, 0.5, 1.0, 2.25})
    for (const double factor : {1e-3, 1.0, 700.0})
      EXPECT_NEAR(fitted_exponent(power(factor, exponent)), exponent, 1e-12);
}

TEST(FittedExponent, LeavesOutPointsWithoutALogarithm) {
  std::vector<Measured> points = power(2, 0.5);
  points.push_back({0, 5});
  points.push_back({7, 0});
  EXPECT_NEAR(fitted_exponent(points), 0.5, 1e-12);
}

/// By hand: logarithms (0, 0), (1, 1), (2, 1) have the slope 1/2.
TEST(FittedExponent, IsTheLeastSquaresSlope) {
  const std::vector<Measured> points = {
      {1, 1}, {std::exp(1), std::exp(1)}, {std::exp(2), std::exp(1)}};
  EXPECT_NEAR(fitted_exponent(points), 0.5, 1e-12);
}

}  // namespace
}  // namespace pelt::reproduce

#include "paper/refit.hpp"
#include "support/random.hpp"
#include "support/skinned_shapes.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace pelt::paper {
namespace {

using test::Motion;
using test::Random;

using Symmetric = std::array<std::array<long double, 3>, 3>;

Symmetric gram(const Matrix4& joint) {
  Symmetric g{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      for (std::size_t row = 0; row < 3; ++row)
        g[i][j] += static_cast<long double>(joint.m[4 * i + row]) *
                   static_cast<long double>(joint.m[4 * j + row]);
  return g;
}

/// One rotation of Jacobi's method, which makes g[p][q] zero.
void rotate(Symmetric& g, std::size_t p, std::size_t q) {
  if (g[p][q] == 0) return;
  const long double theta = (g[q][q] - g[p][p]) / (2 * g[p][q]);
  const long double t = (theta < 0 ? -1 : 1) / (std::fabs(theta) + std::sqrt(theta * theta + 1));
  const long double c = 1 / std::sqrt(t * t + 1), s = t * c;
  for (std::size_t k = 0; k < 3; ++k) {
    const long double kp = g[k][p], kq = g[k][q];
    g[k][p] = c * kp - s * kq;
    g[k][q] = s * kp + c * kq;
  }
  for (std::size_t k = 0; k < 3; ++k) {
    const long double pk = g[p][k], qk = g[q][k];
    g[p][k] = c * pk - s * qk;
    g[q][k] = s * pk + c * qk;
  }
}

/// |A|_2, the root of the largest eigenvalue of A^T A.
double operator_norm(const Matrix4& joint) {
  Symmetric g = gram(joint);
  for (int sweep = 0; sweep < 12; ++sweep) {
    rotate(g, 0, 1);
    rotate(g, 0, 2);
    rotate(g, 1, 2);
  }
  return static_cast<double>(std::sqrt(std::max({g[0][0], g[1][1], g[2][2], 0.0L})));
}

Matrix4 matrix_of(const std::array<double, 9>& columns, double scale = 1) {
  Matrix4 matrix;
  for (std::size_t column = 0; column < 3; ++column)
    for (std::size_t row = 0; row < 3; ++row)
      matrix.m[4 * column + row] = static_cast<float>(scale * columns[3 * column + row]);
  return matrix;
}

void expect_bound(const Matrix4& matrix) {
  const double norm = operator_norm(matrix), bound = static_cast<double>(stretch_bound(matrix));
  ASSERT_GE(bound, norm);
  ASSERT_LE(bound, 1.04 * norm);
}

TEST(StretchBound, IsAtLeastTheNormAndAtMostFourPercentMore) {
  Random random(1);
  for (int i = 0; i < 20000; ++i) {
    std::array<double, 9> entries;
    for (double& entry : entries) entry = random.chance(0.2) ? 0 : random.uniform(-1, 1);
    ASSERT_NO_FATAL_FAILURE(
        expect_bound(matrix_of(entries, std::pow(10, random.uniform(-12, 12)))));
  }
}

TEST(StretchBound, IsOneForRotationsAndReflections) {
  Random random(2);
  for (const Matrix4& rotation : make_palette(random, 2000, Motion::rigid, 1)) {
    Matrix4 reflection = rotation;
    for (std::size_t row = 0; row < 3; ++row) reflection.m[row] = -reflection.m[row];
    for (const Matrix4& matrix : {rotation, reflection}) {
      ASSERT_GE(stretch_bound(matrix), operator_norm(matrix));
      ASSERT_NEAR(stretch_bound(matrix), 1, 0x1p-19);
    }
  }
  EXPECT_GE(stretch_bound(Matrix4()), 1);
  EXPECT_LE(stretch_bound(Matrix4()), 1 + 0x1p-19f);
}

TEST(StretchBound, IsTheScaleOfScaledRotations) {
  Random random(3);
  for (Matrix4 matrix : make_palette(random, 1000, Motion::rigid, 1)) {
    const float scale = random.uniformf(1e-4, 300);
    for (std::size_t i = 0; i < 12; ++i) matrix.m[i] *= scale;
    ASSERT_NEAR(stretch_bound(matrix), scale, 0x1p-18 * static_cast<double>(scale));
  }
}

TEST(StretchBound, OfRankOneIsTheProductOfTheLengths) {
  Random random(4);
  for (int i = 0; i < 2000; ++i) {
    const Vec3 u = random.point(1), v = random.point(1);
    ASSERT_NO_FATAL_FAILURE(
        expect_bound(matrix_of({u.x * v.x, u.y * v.x, u.z * v.x, u.x * v.y, u.y * v.y, u.z * v.y,
                                u.x * v.z, u.y * v.z, u.z * v.z})));
  }
}

TEST(StretchBound, OfNothingIsNothing) {
  EXPECT_EQ(stretch_bound(matrix_of({0, 0, 0, 0, 0, 0, 0, 0, 0})), 0);
}

}  // namespace
}  // namespace pelt::paper

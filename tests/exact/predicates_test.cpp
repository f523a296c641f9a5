#include "exact/predicates.hpp"

#include "finite_floats.hpp"
#include "geometry/triangle_cases.hpp"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <cmath>

namespace pelt::test {
namespace {

using detail::exact_sign_count;
using detail::orient2d;
using detail::orient3d;
using detail::Vec2d;

mpz_class exact(double x) { return mpz_class(std::ldexp(x, 149)); }

int exact_orient3d(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const auto difference = [&](const Vec3& p) {
    return std::array<mpz_class, 3>{exact(p.x) - exact(a.x), exact(p.y) - exact(a.y),
                                    exact(p.z) - exact(a.z)};
  };
  const auto u = difference(b), v = difference(c), w = difference(d);
  const mpz_class determinant = u[0] * (v[1] * w[2] - v[2] * w[1]) +
                                u[1] * (v[2] * w[0] - v[0] * w[2]) +
                                u[2] * (v[0] * w[1] - v[1] * w[0]);
  return sgn(determinant);
}

int exact_orient2d(const Vec2d& a, const Vec2d& b, const Vec2d& c) {
  const mpz_class determinant = (exact(b.x) - exact(a.x)) * (exact(c.y) - exact(a.y)) -
                                (exact(b.y) - exact(a.y)) * (exact(c.x) - exact(a.x));
  return sgn(determinant);
}

/// Number of times that each sign occurred; a test needs all three.
struct SignCounts {
  int negative = 0, zero = 0, positive = 0;

  void add(int sign) { ++(sign < 0 ? negative : sign > 0 ? positive : zero); }
  void expect_each_at_least(int count) const {
    EXPECT_GE(negative, count);
    EXPECT_GE(zero, count);
    EXPECT_GE(positive, count);
  }
};

TEST(Orient3d, IsPositiveWhereCornersAreSeenCounterClockwise) {
  const Vec3 a{0, 0, 0}, b{1, 0, 0}, c{0, 1, 0};
  EXPECT_EQ(orient3d(a, b, c, {5, 5, 1}), 1);
  EXPECT_EQ(orient3d(a, b, c, {5, 5, -1}), -1);
  EXPECT_EQ(orient3d(a, b, c, {5, 5, 0}), 0);
}

TEST(Orient3d, IsZeroEverywhereOfCollinearPoints) {
  EXPECT_EQ(orient3d({0, 0, 0}, {1, 2, 3}, {2, 4, 6}, {7, 1, 5}), 0);
  EXPECT_EQ(orient3d({1, 2, 3}, {1, 2, 3}, {2, 4, 7}, {7, 1, 5}), 0);
}

TEST(Orient3d, SeesOneSubnormalUnitBesideOne) {
  const Vec3 a{0, 0, 0}, b{1, 1, 1}, c{1, 2, 3};
  EXPECT_EQ(orient3d(a, b, c, {2, 3, 4}), 0);
  EXPECT_EQ(orient3d(a, b, c, {0x1p-149f, 0, 0}), 1);
  EXPECT_EQ(orient3d(a, b, c, {-0x1p-149f, 0, 0}), -1);
  EXPECT_EQ(orient3d({0, 0x1p-149f, 0}, b, c, {2, 3, 4}),
            exact_orient3d({0, 0x1p-149f, 0}, b, c, {2, 3, 4}));
}

TEST(Orient3d, EqualsExactSignOfAnyFloats) {
  Random random = seeded(21);
  SignCounts signs;
  const std::uint64_t exact_before = exact_sign_count();
  for (int i = 0; i < 200'000; ++i) {
    const auto coordinate = i % 2 ? any_finite_float : one_of_few_floats;
    const auto [a, b, c] = corners_of(random, coordinate);
    const Vec3 d = corners_of(random, coordinate)[0];
    const int expected = exact_orient3d(a, b, c, d);
    ASSERT_EQ(orient3d(a, b, c, d), expected) << "case " << i;
    signs.add(expected);
  }
  signs.expect_each_at_least(500);
  EXPECT_GT(exact_sign_count(), exact_before + 10'000);
}

TEST(Orient3d, EqualsExactSignOfNearlyCoplanarPoints) {
  Random random = seeded(22);
  SignCounts signs;
  const std::uint64_t exact_before = exact_sign_count();
  for (int i = 0; i < 200'000; ++i) {
    const IntegerPair pair = sheared_grid(random);
    const int exponent = uniform(random, 0, 1) ? -149 : 104;
    const auto [a, b, c] = scaled(pair.a, exponent);
    const Vec3 d = scaled(pair.b, exponent)[0];
    const int expected = exact_orient3d(a, b, c, d);
    ASSERT_EQ(orient3d(a, b, c, d), expected) << "case " << i;
    signs.add(expected);
  }
  signs.expect_each_at_least(20'000);
  EXPECT_GT(exact_sign_count(), exact_before + 100'000);
}

/// Planes through one axis at 45 degrees: the six products cancel in pairs, down to the last bit of
/// the longest differences of floats.
TEST(Orient3d, IsZeroOnDiagonalPlanes) {
  Random random = seeded(25);
  const auto coordinate = [&] {
    const int exponent = random() % 2 ? -24 : -50;
    return static_cast<float>(std::ldexp(uniform(random, -kLimit, kLimit), exponent));
  };
  for (int i = 0; i < 20'000; ++i) {
    std::array<Vec3, 4> p;
    for (Vec3& q : p) {
      const float s = coordinate(), t = coordinate();
      q = std::array{Vec3{s, s, t}, Vec3{s, t, s}, Vec3{t, s, s}}[i % 3];
    }
    ASSERT_EQ(orient3d(p[0], p[1], p[2], p[3]), 0) << "case " << i;
  }
}

TEST(Orient3d, FilterDecidesPointsInGeneralPosition) {
  Random random = seeded(23);
  const std::uint64_t exact_before = exact_sign_count();
  for (int i = 0; i < 100'000; ++i) {
    const auto [a, b, c] = scaled(uniform_corners(random, -kLimit, kLimit), -24);
    const Vec3 d = scaled(uniform_corners(random, -kLimit, kLimit), -24)[0];
    ASSERT_NE(orient3d(a, b, c, d), 0);
  }
  EXPECT_EQ(exact_sign_count(), exact_before);
}

TEST(Orient2d, IsPositiveForCounterClockwiseTurn) {
  EXPECT_EQ(orient2d({0, 0}, {1, 0}, {0, 1}), 1);
  EXPECT_EQ(orient2d({0, 0}, {0, 1}, {1, 0}), -1);
  EXPECT_EQ(orient2d({0, 0}, {1, 3}, {2, 6}), 0);
}

TEST(Orient2d, EqualsExactSignOfAnyFloats) {
  Random random = seeded(24);
  SignCounts signs;
  const std::uint64_t exact_before = exact_sign_count();
  for (int i = 0; i < 300'000; ++i) {
    const auto coordinate = i % 2 ? any_finite_float : one_of_few_floats;
    const auto point = [&] { return Vec2d{coordinate(random), coordinate(random)}; };
    const Vec2d a = point(), b = point(), c = point();
    const int expected = exact_orient2d(a, b, c);
    ASSERT_EQ(orient2d(a, b, c), expected) << "case " << i;
    signs.add(expected);
  }
  signs.expect_each_at_least(500);
  EXPECT_GT(exact_sign_count(), exact_before + 1'000);
}

}  // namespace
}  // namespace pelt::test

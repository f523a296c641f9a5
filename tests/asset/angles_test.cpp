#include "asset/transform.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace pelt::asset {
namespace {

TEST(Angles, SineAgreesWithLibm) {
  for (int i = -100000; i <= 100000; ++i) {
    const double x = i / 100000.0 * (kPi / 2);
    ASSERT_NEAR(sine(x), std::sin(x), 3e-16) << x;
  }
}

TEST(Angles, TurnsAgreeWithLibmAndArePeriodic) {
  for (int i = -30000; i <= 30000; ++i) {
    const double turns = i / 10000.0;
    ASSERT_NEAR(sine_of_turns(turns), std::sin(2 * kPi * turns), 4e-15) << turns;
    ASSERT_NEAR(cosine_of_turns(turns), std::cos(2 * kPi * turns), 4e-15) << turns;
  }
  for (int i = 0; i < 64; ++i) {
    EXPECT_EQ(sine_of_turns(i / 64.0), sine_of_turns(i / 64.0 + 5));
    EXPECT_EQ(cosine_of_turns(i / 64.0), cosine_of_turns(i / 64.0 - 3));
  }
}

TEST(Angles, QuartersOfATurnAreExact) {
  EXPECT_EQ(sine_of_turns(0), 0);
  EXPECT_NEAR(sine_of_turns(0.25), 1, 1e-15);
  EXPECT_NEAR(cosine_of_turns(0.25), 0, 1e-15);
  EXPECT_NEAR(cosine_of_turns(0.5), -1, 1e-15);
}

TEST(Angles, AngleOfAgreesWithLibmOverTheWholeQuarter) {
  for (int i = 0; i <= 100000; ++i) {
    const double angle = i / 100000.0 * (kPi / 2);
    const double s = std::sin(angle), c = std::max(0.0, std::cos(angle));
    ASSERT_NEAR(angle_of(s, c), angle, 1e-15) << angle;
    ASSERT_NEAR(angle_of(0.125 * s, 0.125 * c), angle, 1e-15) << angle;
  }
}

Quaternion random_rotation(std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  return normalised({normal(random), normal(random), normal(random), normal(random)});
}

Quaternion libm_slerp(const Quaternion& a, Quaternion b, double t) {
  if (dot(a, b) < 0) b = {-b.x, -b.y, -b.z, -b.w};
  const double angle = std::acos(std::min(1.0, dot(a, b)));
  const double s = std::sin(angle);
  return blend(a, std::sin((1 - t) * angle) / s, b, std::sin(t * angle) / s);
}

TEST(Quaternion, SlerpAgreesWithLibmOnTheShorterWay) {
  constexpr std::uint64_t kSeed = 20050301;
  SCOPED_TRACE(kSeed);
  std::mt19937_64 random(kSeed);
  std::uniform_real_distribution<double> unit(0, 1);
  int longer_way = 0;
  for (int i = 0; i < 20000; ++i) {
    const Quaternion a = random_rotation(random), b = random_rotation(random);
    const double t = unit(random);
    longer_way += dot(a, b) < 0;
    const Quaternion expected = libm_slerp(a, b, t), q = slerp(a, b, t);
    ASSERT_NEAR(squared_length(detail::Vec3d(q.x - expected.x, q.y - expected.y, q.z - expected.z)),
                0, 1e-24);
    ASSERT_NEAR(q.w, expected.w, 1e-12);
  }
  EXPECT_GT(longer_way, 8000);
}

TEST(Quaternion, SlerpOfNearlyEqualAndOppositeStaysAUnitQuaternion) {
  for (double distance = 1e-18; distance < 0.1; distance *= 3) {
    const Quaternion a = normalised({0.3, -0.5, 0.1, 0.8});
    const Quaternion b = normalised({a.x + distance, a.y, a.z, a.w});
    for (double sign : {1.0, -1.0}) {
      const Quaternion q = slerp(a, {sign * b.x, sign * b.y, sign * b.z, sign * b.w}, 0.25);
      ASSERT_NEAR(dot(q, q), 1, 1e-12);
      ASSERT_NEAR(q.x, a.x + 0.25 * (b.x - a.x),
                  1e-2 * distance * distance + 1e-15 + distance * 1e-3);
      ASSERT_GT(dot(q, a), 0.99);
    }
  }
}

TEST(Quaternion, RotatesLikeItsMatrix) {
  const double half = std::sqrt(0.5);
  const detail::Vec3d v = rotate({0, 0, half, half}, {1, 2, 3});
  EXPECT_NEAR(v.x, -2, 1e-15);
  EXPECT_NEAR(v.y, 1, 1e-15);
  EXPECT_NEAR(v.z, 3, 1e-15);
}

TEST(Quaternion, ZeroNormalisesToTheIdentity) {
  const Quaternion q = normalised({0, 0, 0, 0});
  EXPECT_EQ(q.w, 1);
  EXPECT_EQ(q.x, 0);
}

}  // namespace
}  // namespace pelt::asset

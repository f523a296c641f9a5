#include "asset/clip.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace pelt::asset {
namespace {

Channel translation_channel(Interpolation interpolation, std::vector<float> times,
                            std::vector<float> values) {
  return {0, Path::translation, interpolation, std::move(times), std::move(values)};
}

TEST(Channel, LinearInterpolatesAndClamps) {
  const Channel channel =
      translation_channel(Interpolation::linear, {1, 2, 4}, {0, 0, 0, 1, 10, -1, 3, 20, -5});
  const std::array<double, 4> middle = sample_channel(channel, 3);
  EXPECT_EQ(middle[0], 2);
  EXPECT_EQ(middle[1], 15);
  EXPECT_EQ(middle[2], -3);
  EXPECT_EQ(sample_channel(channel, 2)[1], 10);
  EXPECT_EQ(sample_channel(channel, 0)[0], 0);
  EXPECT_EQ(sample_channel(channel, -7)[1], 0);
  EXPECT_EQ(sample_channel(channel, 99)[1], 20);
  EXPECT_EQ(sample_channel(channel, std::numeric_limits<float>::infinity())[1], 20);
  EXPECT_EQ(sample_channel(channel, std::numeric_limits<float>::quiet_NaN())[1], 0);
}

TEST(Channel, StepReturnsTheValueOfTheLastKey) {
  const Channel channel = translation_channel(Interpolation::step, {0, 1}, {1, 2, 3, 4, 5, 6});
  EXPECT_EQ(sample_channel(channel, 0.999f)[0], 1);
  EXPECT_EQ(sample_channel(channel, 1)[0], 4);
}

TEST(Channel, SingleKeyAppliesAtAllTimes) {
  for (Interpolation interpolation : {Interpolation::step, Interpolation::linear}) {
    const Channel channel = translation_channel(interpolation, {0}, {7, 8, 9});
    for (float seconds : {-1.0f, 0.0f, 1.0f}) EXPECT_EQ(sample_channel(channel, seconds)[2], 9);
  }
  const Channel cubic =
      translation_channel(Interpolation::cubic_spline, {0}, {1, 1, 1, 7, 8, 9, 2, 2, 2});
  for (float seconds : {-1.0f, 0.0f, 1.0f}) EXPECT_EQ(sample_channel(cubic, seconds)[1], 8);
}

// A cubic is its own Hermite spline: sampled values and slopes of t^3 - 2 t^2 + 3 reproduce it. The
// intervals do not have length 1, so tangents must be scaled by the length.
TEST(Channel, CubicSplineReproducesACubic) {
  const auto value = [](double t) { return t * t * t - 2 * t * t + 3; };
  const auto slope = [](double t) { return 3 * t * t - 4 * t; };
  Channel channel = translation_channel(Interpolation::cubic_spline, {0, 0.5f, 2.5f}, {});
  for (float t : channel.times) {
    for (double number : {slope(t), value(t), slope(t)}) {
      channel.values.insert(channel.values.end(), 3, static_cast<float>(number));
    }
  }
  for (float t = 0; t <= 2.5f; t += 0.0625f) {
    EXPECT_NEAR(sample_channel(channel, t)[1], value(t), 1e-12) << t;
  }
}

TEST(Channel, CubicSplineRotationIsNormalised) {
  const float half = std::sqrt(0.5f);
  const Channel channel = {
      0, Path::rotation, Interpolation::cubic_spline, {0, 1}, {0,    0,    0, 0, 0, 0,
                                                               0,    1,    0, 0, 0, 0,  //
                                                               0,    0,    0, 0, 0, 0,
                                                               half, half, 0, 0, 0, 0}};
  const std::array<double, 4> q = sample_channel(channel, 0.5f);
  EXPECT_NEAR(q[2] * q[2] + q[3] * q[3], 1, 1e-15);
  EXPECT_NEAR(q[2], std::sin(3.14159265358979 / 8), 1e-7);
}

TEST(Channel, LinearRotationTakesTheShorterWay) {
  const float half = std::sqrt(0.5f);
  const Channel channel = {
      0, Path::rotation, Interpolation::linear, {0, 1}, {0, 0, 0, 1, 0, 0, -half, -half}};
  const std::array<double, 4> q = sample_channel(channel, 1.0f / 3);
  EXPECT_NEAR(q[2], std::sin(3.14159265358979 / 12), 1e-7);
  EXPECT_NEAR(q[3], std::cos(3.14159265358979 / 12), 1e-7);
}

}  // namespace
}  // namespace pelt::asset

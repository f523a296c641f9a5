#include "base/double4.hpp"
#include "base/float4.hpp"
#include "base/lane_operations.hpp"
#include "support/instruction_sets.hpp"
#include "support/random.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <limits>

namespace pelt::test {
namespace {

constexpr Compiled<LaneOperations> kLaneOperations[] = PELT_ALL_COMPILED(lane_operations);
constexpr Compiled<TurnPoints> kTurnPoints[] = PELT_ALL_COMPILED(turn_points);
constexpr Compiled<ShortOperations> kShortOperations[] = PELT_ALL_COMPILED(short_operations);

/// Calls `body(function)` for each function that runs here.
template <typename Functions, typename Body>
void for_each(const Functions& functions, const Body& body) {
  int ran = 0;
  for (const auto& [set, function] : functions) {
    if (!runs_here(set)) continue;
    SCOPED_TRACE(name_of(set));
    body(function);
    ++ran;
  }
  EXPECT_EQ(ran, std::ssize(available_instruction_sets()));
}

/// Bitwise equality, except that all NaNs are equal.
bool same(float x, float y) {
  return std::bit_cast<std::uint32_t>(x) == std::bit_cast<std::uint32_t>(y) ||
         (std::isnan(x) && std::isnan(y));
}

float interesting_float(Random& random) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  constexpr float kSpecial[] = {0.0f,
                                -0.0f,
                                1.0f,
                                -1.0f,
                                1e-45f,
                                -1e-45f,
                                0x1p-126f,
                                0x1p-127f,
                                1e38f,
                                -3e38f,
                                kInfinity,
                                -kInfinity,
                                std::numeric_limits<float>::quiet_NaN()};
  if (random.chance(0.4)) return kSpecial[random.index(std::size(kSpecial))];
  const float magnitude = std::ldexp(1.0f, static_cast<int>(random.index(250)) - 125);
  return magnitude * random.uniformf(-2, 2);
}

void expect_results(const LaneResults& results, const float* a, const float* b) {
  for (unsigned i = 0; i < 8; ++i) {
    SCOPED_TRACE(testing::Message() << a[i] << " and " << b[i]);
    EXPECT_PRED2(same, results.sum[i], a[i] + b[i]);
    EXPECT_PRED2(same, results.difference[i], a[i] - b[i]);
    EXPECT_PRED2(same, results.product[i], a[i] * b[i]);
    const float product = a[i] * b[i];
    EXPECT_PRED2(same, results.product_and_sum[i], product + a[i]) << "never fused";
    EXPECT_PRED2(same, results.least[i], a[i] < b[i] ? a[i] : b[i]);
    EXPECT_PRED2(same, results.most[i], a[i] > b[i] ? a[i] : b[i]);
    EXPECT_PRED2(same, results.size[i], std::fabs(a[i]));
    EXPECT_PRED2(same, results.chosen[i], a[i] < b[i] ? a[i] : b[i]);
    EXPECT_PRED2(same, results.repeated[i], a[3]);
    EXPECT_PRED2(same, results.paired[i], i < 4 ? a[1] : b[6]);
    EXPECT_PRED2(same, results.joined[i], i < 4 ? b[4 + i] : a[i - 4]);
    const bool less = a[i] < b[i], at_most = b[i] <= 1;
    const auto bit = [i](unsigned mask) { return (mask >> i & 1) != 0; };
    EXPECT_EQ(bit(results.less), less);
    EXPECT_EQ(bit(results.less_equal), a[i] <= b[i]);
    EXPECT_EQ(bit(results.both), less && at_most);
    EXPECT_EQ(bit(results.either), less || at_most);
    EXPECT_EQ(bit(results.one_of_both), less != at_most);
  }
  for (unsigned i = 0; i < 4; ++i) {
    EXPECT_PRED2(same, results.low[i], a[i]);
    EXPECT_PRED2(same, results.high[i], a[4 + i]);
    EXPECT_PRED2(same, results.folded[i], a[i] + a[4 + i]);
  }
  for (const unsigned mask : {results.less, results.less_equal, results.both, results.either})
    EXPECT_LT(mask, 256u);
}

TEST(Float8, DoesInEachLaneWhatPlainFloatsDo) {
  for_each(kLaneOperations, [](LaneOperations* lane_operations) {
    Random random(40);
    float a[9], b[9];
    for (int round = 0; round < 3000 && !testing::Test::HasFailure(); ++round) {
      for (float& x : a) x = interesting_float(random);
      for (float& x : b) x = interesting_float(random);
      if (random.chance(0.2)) b[2] = a[2];
      const int offset = round % 2;  // addresses that are not multiples of a row's size
      expect_results(lane_operations(a + offset, b + offset), a + offset, b + offset);
    }
  });
}

TEST(Float8, TurnsPointsIntoCoordinates) {
  float points[33];
  for (int i = 0; i < 33; ++i) points[i] = static_cast<float>(i);
  for_each(kTurnPoints, [&](TurnPoints* turn_points) {
    const TurnedPoints turned = turn_points(points + 1);
    for (int i = 0; i < 8; ++i) {
      EXPECT_EQ(turned.x[i], points[1 + 4 * i]);
      EXPECT_EQ(turned.y[i], points[2 + 4 * i]);
      EXPECT_EQ(turned.z[i], points[3 + 4 * i]);
    }
  });
}

std::int16_t interesting_short(Random& random) {
  constexpr std::int16_t kSpecial[] = {0, 1, -1, 32767, -32768, -32767, 255, 256};
  if (random.chance(0.5)) return kSpecial[random.index(std::size(kSpecial))];
  return static_cast<std::int16_t>(random.bits());
}

void expect_results(const ShortResults& results, const std::int16_t* a, const std::int16_t* b,
                    const float* floats) {
  for (unsigned i = 0; i < 16; ++i) {
    EXPECT_EQ(results.first[i], a[i]);
    EXPECT_EQ(results.both[i], a[i] & b[i]);
    EXPECT_EQ(results.repeated[i], a[5]);
    EXPECT_EQ(results.truncated[i], static_cast<int>(floats[i])) << floats[i];
    EXPECT_EQ(results.greater >> i & 1, a[i] > b[i]);
    EXPECT_EQ(results.equal >> i & 1, a[i] == b[i]);
    EXPECT_EQ(results.either >> i & 1, a[i] >= b[i]);
  }
  EXPECT_LT(results.greater | results.equal | results.either, 1u << 16);
}

TEST(Short16, DoesInEachLaneWhatPlainIntegersDo) {
  for_each(kShortOperations, [](ShortOperations* short_operations) {
    Random random(41);
    std::int16_t a[17], b[17];
    float floats[17];
    for (int round = 0; round < 2000 && !testing::Test::HasFailure(); ++round) {
      std::generate(a, a + 17, [&] { return interesting_short(random); });
      std::generate(b, b + 17, [&] { return interesting_short(random); });
      for (int i = 0; i < 17; ++i) {
        if (random.chance(0.2)) b[i] = a[i];
        floats[i] = random.chance(0.5) ? interesting_short(random) : random.uniformf(-300, 300);
      }
      const int offset = round % 2;  // addresses that are not multiples of a row's size
      expect_results(short_operations(a + offset, b + offset, floats + offset), a + offset,
                     b + offset, floats + offset);
    }
  });
}

}  // namespace
}  // namespace pelt::test

namespace pelt::detail {
namespace {

void expect_lanes(const Float4& v, float x, float y, float z, float w) {
  EXPECT_EQ(v[0], x);
  EXPECT_EQ(v[1], y);
  EXPECT_EQ(v[2], z);
  EXPECT_EQ(v[3], w);
}

TEST(Float4, WorksLaneByLane) {
  const Float4 a(1, 2, 3, 4), b(8, 6, 4, 2);
  expect_lanes(a + b, 9, 8, 7, 6);
  expect_lanes(a - b, -7, -4, -1, 2);
  expect_lanes(a * b, 8, 12, 12, 8);
  expect_lanes(2 * a, 2, 4, 6, 8);
  expect_lanes(min(a, b), 1, 2, 3, 2);
  expect_lanes(max(a, b), 8, 6, 4, 4);
  expect_lanes(Float4(5.0f), 5, 5, 5, 5);
}

TEST(Float4, LoadsFromAnyAddress) {
  const float values[] = {0, 1, 2, 3, 4, 5};
  expect_lanes(load4(values + 1), 1, 2, 3, 4);
  expect_lanes(load3(values + 2), 2, 3, 4, 0);
}

const double kAscending[16] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};

template <typename Expected>
void expect_lanes(const Double16& actual, const Expected& expected) {
  for (std::size_t i = 0; i < 16; ++i) EXPECT_EQ(actual[i], expected(kAscending[i])) << i;
}

TEST(Double16, WorksLaneByLane) {
  const Double16 a(kAscending), b(4.5);
  expect_lanes(a, [](double x) { return x; });
  expect_lanes(a + b, [](double x) { return x + 4.5; });
  expect_lanes(a - b, [](double x) { return x - 4.5; });
  expect_lanes(a * b, [](double x) { return x * 4.5; });
  expect_lanes(a / b, [](double x) { return x / 4.5; });
  expect_lanes(2 * a, [](double x) { return 2 * x; });
  expect_lanes(-a, [](double x) { return -x; });
  expect_lanes(abs(a - b), [](double x) { return x < 4.5 ? 4.5 - x : x - 4.5; });
  expect_lanes(min(a, b), [](double x) { return x < 4.5 ? x : 4.5; });
  expect_lanes(max(a, b), [](double x) { return x < 4.5 ? 4.5 : x; });
}

TEST(Double16, ComparesLaneByLane) {
  const Double16 a(kAscending);
  EXPECT_EQ(less(a, Double16(4.5)), 0b11111u);
  EXPECT_EQ(less(Double16(10.0), a), 0xF800u);
  EXPECT_EQ(less(a, a), 0u);
  EXPECT_EQ(less(a, Double16(std::numeric_limits<double>::quiet_NaN())), 0u);
}

TEST(Double16, ReturnsTheSecondOfTwoIfOneIsNotANumber) {
  const Double16 nan(std::numeric_limits<double>::quiet_NaN()), one(1.0);
  expect_lanes(min(nan, one), [](double) { return 1.0; });
  expect_lanes(max(nan, one), [](double) { return 1.0; });
}

}  // namespace
}  // namespace pelt::detail

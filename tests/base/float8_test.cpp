#include "lane_operations.hpp"

#include "support/instruction_sets.hpp"
#include "support/random.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>

namespace pelt {
namespace {

using test::LaneResults;
using test::TurnedPoints;

struct Compiled {
  InstructionSet set;
  test::LaneOperations* lane_operations;
  test::TurnPoints* turn_points;
};

constexpr Compiled kCompiled[] = {
    {InstructionSet::scalar, test::scalar::lane_operations, test::scalar::turn_points},
#ifdef PELT_HAS_SIMD128
    {InstructionSet::simd128, test::simd128::lane_operations, test::simd128::turn_points},
#endif
#ifdef PELT_HAS_AVX2
    {InstructionSet::avx2, test::avx2::lane_operations, test::avx2::turn_points},
#endif
};

template <typename Body>
void on_each_compiled(const Body& body) {
  int ran = 0;
  for (const Compiled& compiled : kCompiled) {
    if (!test::runs_here(compiled.set)) continue;
    SCOPED_TRACE(name_of(compiled.set));
    body(compiled);
    ++ran;
  }
  EXPECT_EQ(ran, std::ssize(available_instruction_sets()));
}

/// Bitwise equality, except that all NaNs are equal.
bool same(float x, float y) {
  return std::bit_cast<std::uint32_t>(x) == std::bit_cast<std::uint32_t>(y) ||
         (std::isnan(x) && std::isnan(y));
}

float interesting_float(test::Random& random) {
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
  on_each_compiled([](const Compiled& compiled) {
    test::Random random(40);
    float a[9], b[9];
    for (int round = 0; round < 3000 && !testing::Test::HasFailure(); ++round) {
      for (float& x : a) x = interesting_float(random);
      for (float& x : b) x = interesting_float(random);
      if (random.chance(0.2)) b[2] = a[2];
      const int offset = round % 2;  // addresses that are not multiples of a row's size
      expect_results(compiled.lane_operations(a + offset, b + offset), a + offset, b + offset);
    }
  });
}

TEST(Float8, TurnsPointsIntoCoordinates) {
  float points[33];
  for (int i = 0; i < 33; ++i) points[i] = static_cast<float>(i);
  on_each_compiled([&](const Compiled& compiled) {
    const TurnedPoints turned = compiled.turn_points(points + 1);
    for (int i = 0; i < 8; ++i) {
      EXPECT_EQ(turned.x[i], points[1 + 4 * i]);
      EXPECT_EQ(turned.y[i], points[2 + 4 * i]);
      EXPECT_EQ(turned.z[i], points[3 + 4 * i]);
    }
  });
}

}  // namespace
}  // namespace pelt

#include "base/float4.hpp"

#include "base/double4.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <limits>

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

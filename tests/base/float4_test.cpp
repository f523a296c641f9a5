#include "base/float4.hpp"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace pelt::detail

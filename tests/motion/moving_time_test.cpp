/// The first time at which moving triangles meet, against exact positions at other times.
#include "many_moving_pairs.hpp"

#include "geometry/triangle_pair.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace pelt::test {
namespace {

using detail::MovingPoints;
using detail::TriangleCorners;

/// 16 times the positions at time k / 16, if these are floats.
std::optional<TriangleCorners> at_sixteenth(const MovingTriangle& t, int k) {
  TriangleCorners result;
  for (std::size_t i = 0; i < 3; ++i)
    for (float Vec3::*const axis : {&Vec3::x, &Vec3::y, &Vec3::z}) {
      const double sum = (16 - k) * double{t.from[i].*axis} + k * double{t.to[i].*axis};
      result[i].*axis = static_cast<float>(sum);
      if (result[i].*axis != sum) return std::nullopt;
    }
  return result;
}

TEST(MovingTime, IsNotAfterATimeAtWhichTheTrianglesIntersect) {
  int later = 0;
  for_many_pairs(207, 1'000, [&](const MovingPair& pair, const auto& meeting) {
    for (int k = 1; k < 16; ++k) {
      const auto a = at_sixteenth(pair.a, k), b = at_sixteenth(pair.b, k);
      if (!a || !b || !detail::triangles_intersect(*a, *b)) continue;
      ASSERT_TRUE(meeting);
      EXPECT_LE(16 * meeting->time, k);
      later += !meeting->at_start;
    }
  });
  EXPECT_GT(later, 1'000);
}

/// Units of time.
constexpr int kBits = 40;

bool is_in_units(float time) {
  return std::ldexp(time, kBits) == std::trunc(std::ldexp(time, kBits));
}

/// The motion between two times, at its own times from 0 to 1. Precondition: both are in units.
MovingPoints part_of(const MovingPoints& points, float start, float end) {
  using Integer = decltype(detail::MovingCoordinate::from);
  const auto at = [](const detail::MovingCoordinate& x, float time) {
    const auto units = static_cast<std::int64_t>(std::ldexp(time, kBits));
    return x.from * Integer((std::int64_t{1} << kBits) - units) + x.to * Integer(units);
  };
  MovingPoints part;
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t axis = 0; axis < 3; ++axis)
      part[i][axis] = {at(points[i][axis], start), at(points[i][axis], end)};
  return part;
}

TEST(MovingTime, IsTheLargestFloatUntilWhichTheTrianglesAreDisjoint) {
  int certified = 0;
  for_many_pairs(208, 1'000, [&](const MovingPair& pair, const auto& meeting) {
    if (!meeting || meeting->at_start || meeting->time == 1) return;
    const float time = meeting->time, next = std::nextafter(time, 1.0f);
    if (!is_in_units(time) || !is_in_units(next)) return;
    const MovingPoints points = detail::moving_points(pair.a, pair.b);
    const auto after = detail::first_meeting(part_of(points, time, next));
    EXPECT_TRUE(after && after->time < 1);
    const auto before = detail::first_meeting(part_of(points, 0, time));
    EXPECT_TRUE(!before || before->time == 1);
    ++certified;
  });
  EXPECT_GT(certified, 200);
}

}  // namespace
}  // namespace pelt::test

/// Moving triangles with known answers, and answers that must agree with each other.

#include "motion/moving_pair.hpp"
#include "geometry/triangle_pair.hpp"
#include "motion/moving_filter.hpp"
#include "motion/moving_floats.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iostream>
#include <optional>

namespace pelt::test {
namespace {

// Pairs of moving triangles of many families, with their first meetings.

/// Calls check(pair, meeting) for each pair until it fails.
template <typename Check>
void for_many_pairs(std::uint64_t seed, int pairs, const Check& check) {
  constexpr std::array kMakers = {close_at_1,
                                  slow,
                                  moving_integers<on_small_grid>,
                                  moving_integers<on_medium_grid>,
                                  moving_integers<in_still_plane>,
                                  moving_integers<with_still_corners>,
                                  moving_integers<always_collapsed>,
                                  moving_integers<swapping>,
                                  moving_integers<nearly_meeting>,
                                  moving_integers<grazing>};
  Random random(seed);
  int later = 0;
  for (int i = 0; i < pairs && !testing::Test::HasFailure(); ++i) {
    const MovingPair pair = kMakers[static_cast<std::size_t>(i) % kMakers.size()](random);
    SCOPED_TRACE(to_text(pair));
    const auto meeting = detail::first_meeting(pair.a, pair.b);
    later += meeting && !meeting->at_start;
    check(pair, meeting);
  }
  std::cout << "seed " << seed << ": " << pairs << " pairs, " << later << " meet after the start\n";
  EXPECT_GT(later, pairs / 10);
}

using detail::first_meeting;
using detail::FirstMeeting;
using detail::TriangleCorners;
using detail::triangles_intersect;
using Kind = FeatureKind;

constexpr TriangleCorners kFlat = {{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}};

TriangleCorners moved(const TriangleCorners& t, const Vec3& shift) {
  TriangleCorners result = t;
  for (Vec3& p : result) p = p + shift;
  return result;
}

/// Expects the same answer with a filter and without.
std::optional<FirstMeeting> meeting_of(const MovingPair& pair) {
  const auto meeting = first_meeting(pair.a, pair.b);
  MovingStats work;
  EXPECT_EQ(detail::find_first_meeting(pair.a, pair.b, work), meeting);
  EXPECT_EQ(detail::intersect_while_moving(pair.a, pair.b, work), meeting.has_value());
  return meeting;
}

/// b moves by `shift`; a stands still.
MovingPair shifted(const TriangleCorners& a, const TriangleCorners& b, const Vec3& shift) {
  return {{a, a}, {b, moved(b, shift)}};
}

FirstMeeting met(float time, Feature a, Feature b) { return {time, false, a, b}; }

TEST(MovingPair, PassesThroughAFaceBetweenTheEnds) {
  const TriangleCorners spike = {{{1, 1, 1}, {1, 2, 2}, {2, 1, 2}}};
  EXPECT_EQ(meeting_of(shifted(kFlat, spike, {0, 0, -8})),
            met(0.125f, {Kind::face, 0}, {Kind::corner, 0}));
  EXPECT_EQ(meeting_of(shifted(spike, kFlat, {0, 0, 8})),
            met(0.125f, {Kind::corner, 0}, {Kind::face, 0}));
  EXPECT_EQ(meeting_of(shifted(kFlat, spike, {0, 0, -1})),
            met(1, {Kind::face, 0}, {Kind::corner, 0}));
  EXPECT_EQ(meeting_of(shifted(kFlat, spike, {0, 0, -0.5f})), std::nullopt);
  EXPECT_EQ(meeting_of(shifted(kFlat, spike, {40, 0, -8})), std::nullopt);
}

TEST(MovingPair, RoundsTheTimeDown) {
  const TriangleCorners spike = {{{1, 1, 1}, {1, 2, 2}, {2, 1, 2}}};
  const auto meeting = meeting_of(shifted(kFlat, spike, {0, 0, -3}));
  ASSERT_TRUE(meeting);
  EXPECT_LE(3 * double{meeting->time}, 1);
  EXPECT_GT(3 * double{std::nextafter(meeting->time, 1.0f)}, 1);
}

TEST(MovingPair, MeetsEdgeToEdgeAndCornerToCorner) {
  const TriangleCorners upright = {{{1, -3, -1}, {1, -3, 1}, {1, -9, 0}}};
  EXPECT_EQ(meeting_of(shifted(kFlat, upright, {0, 4, 0})),
            met(0.75f, {Kind::edge, 0}, {Kind::edge, 0}));
  EXPECT_EQ(meeting_of(shifted(kFlat, moved(upright, {0, 0, 1}), {0, 4, 0})),
            met(0.75f, {Kind::edge, 0}, {Kind::corner, 0}));
  EXPECT_EQ(meeting_of(shifted(kFlat, moved(upright, {-1, 0, 1}), {0, 4, 0})),
            met(0.75f, {Kind::corner, 0}, {Kind::corner, 0}));
}

TEST(MovingPair, SlidesInOnePlaneAndOnOneLine) {
  EXPECT_EQ(meeting_of(shifted(kFlat, moved(kFlat, {8, 0, 0}), {-16, 0, 0})),
            met(0.25f, {Kind::corner, 1}, {Kind::corner, 0}));
  const TriangleCorners segment = {{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}};
  EXPECT_EQ(meeting_of(shifted(segment, moved(segment, {6, 6, 6}), {-8, -8, -8})),
            met(0.5f, {Kind::corner, 2}, {Kind::corner, 0}));
}

TEST(MovingPair, TouchesForOneInstantWhileCollapsed) {
  // b's first two corners change places. At half time, b is a segment that ends at a's plane.
  const MovingTriangle b = {{{{1, 1, -1}, {1, 1, 1}, {9, 9, 0}}},
                            {{{1, 1, 1}, {1, 1, -1}, {9, 9, 0}}}};
  const TriangleCorners below = {{{1, 1, 0}, {1, 2, 0}, {0, 1, 0}}};
  const auto meeting = meeting_of({{moved(below, {0, 0, -5}), moved(below, {0, 0, 5})}, b});
  ASSERT_TRUE(meeting);
  EXPECT_FALSE(meeting->at_start);
}

TEST(MovingPair, MeetsAtATimeThatRoundsToTheStart) {
  const TriangleCorners spike = {{{1, 1, 0x1p-149f}, {1, 2, 1}, {2, 1, 1}}};
  const auto meeting = meeting_of(shifted(kFlat, spike, {0, 0, -0x1p50f}));
  EXPECT_EQ(meeting, met(0, {Kind::face, 0}, {Kind::corner, 0}));
}

// Metamorphic tests.

MovingTriangle reversed(const MovingTriangle& t) { return {t.to, t.from}; }

TEST(MovingPair, MeetsAlsoBackwards) {
  for_many_pairs(201, 2'000, [](const MovingPair& pair, const auto& meeting) {
    EXPECT_EQ(first_meeting(reversed(pair.a), reversed(pair.b)).has_value(), meeting.has_value());
  });
}

TEST(MovingPair, MeetsAtTheSameTimeInAnyOrder) {
  for_many_pairs(202, 2'000, [](const MovingPair& pair, const auto& meeting) {
    const auto turned = [](const TriangleCorners& t) { return TriangleCorners{t[2], t[0], t[1]}; };
    const auto mirrored = [](const TriangleCorners& t) {
      return TriangleCorners{t[1], t[0], t[2]};
    };
    const MovingTriangle a = {turned(pair.a.from), turned(pair.a.to)};
    const MovingTriangle b = {mirrored(pair.b.from), mirrored(pair.b.to)};
    const auto other = first_meeting(b, a);
    ASSERT_EQ(other.has_value(), meeting.has_value());
    if (!meeting) return;
    EXPECT_EQ(other->time, meeting->time);
    EXPECT_EQ(other->at_start, meeting->at_start);
  });
}

TEST(MovingPair, MeetsWhenTheStaticTestFindsThatItDoes) {
  for_many_pairs(203, 2'000, [](const MovingPair& pair, const auto& meeting) {
    EXPECT_EQ(meeting && meeting->at_start, triangles_intersect(pair.a.from, pair.b.from));
    if (triangles_intersect(pair.a.to, pair.b.to)) {
      EXPECT_TRUE(meeting);
    }
    const MovingTriangle still_a = {pair.a.to, pair.a.to}, still_b = {pair.b.to, pair.b.to};
    const auto still = first_meeting(still_a, still_b);
    EXPECT_EQ(still.has_value(), triangles_intersect(pair.a.to, pair.b.to));
    EXPECT_TRUE(!still || still->at_start);
  });
}

/// The mean of both ends, if that is exact.
bool find_middle(const MovingTriangle& t, TriangleCorners& middle) {
  for (std::size_t i = 0; i < 3; ++i) {
    const auto mean = [](float x, float y) { return (double{x} + double{y}) / 2; };
    const Vec3 &p = t.from[i], &q = t.to[i];
    const double x = mean(p.x, q.x), y = mean(p.y, q.y), z = mean(p.z, q.z);
    middle[i] = {static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)};
    if (middle[i].x != x || middle[i].y != y || middle[i].z != z) return false;
  }
  return true;
}

TEST(MovingPair, MeetsInOneOfTwoHalves) {
  int halved = 0;
  for_many_pairs(204, 3'000, [&](const MovingPair& pair, const auto& meeting) {
    TriangleCorners a, b;
    if (!find_middle(pair.a, a) || !find_middle(pair.b, b)) return;
    ++halved;
    const auto first = first_meeting({pair.a.from, a}, {pair.b.from, b});
    const auto second = first_meeting({a, pair.a.to}, {b, pair.b.to});
    EXPECT_EQ(meeting.has_value(), first.has_value() || second.has_value());
    if (first) {
      EXPECT_EQ(meeting->time, first->time / 2);
      EXPECT_EQ(meeting->a, first->a);
      EXPECT_EQ(meeting->b, first->b);
    } else if (second) {
      EXPECT_GE(meeting->time, 0.5f);
      EXPECT_LE(std::abs(meeting->time - (1 + second->time) / 2), 0x1p-24f);
    }
  });
  EXPECT_GT(halved, 200);
}

/// Adds a displacement to all corners at an end. Returns false if that is not exact.
bool displace(TriangleCorners& t, const Vec3& by) {
  bool is_exact = true;
  for (Vec3& p : t)
    for (float Vec3::*const axis : {&Vec3::x, &Vec3::y, &Vec3::z}) {
      const double sum = double{p.*axis} + double{by.*axis};
      p.*axis = static_cast<float>(sum);
      is_exact = is_exact && p.*axis == sum;
    }
  return is_exact;
}

/// Also if the displacement is another one at the end of the step.
TEST(MovingPair, DoesNotDependOnACommonDisplacement) {
  int displaced = 0;
  for_many_pairs(206, 1'000, [&](const MovingPair& pair, const auto& meeting) {
    const Vec3 first = pair.a.to[1], last = pair.b.from[0];
    MovingPair other = pair;
    if (!displace(other.a.from, first) || !displace(other.b.from, first) ||
        !displace(other.a.to, last) || !displace(other.b.to, last))
      return;
    ++displaced;
    EXPECT_EQ(first_meeting(other.a, other.b), meeting);
  });
  EXPECT_GT(displaced, 500);
}

TEST(MovingPair, DoesNotDependOnTheScale) {
  for_many_pairs(205, 1'000, [](const MovingPair& pair, const auto& meeting) {
    MovingPair scaled = pair;
    for (MovingTriangle* t : {&scaled.a, &scaled.b})
      for (TriangleCorners* corners : {&t->from, &t->to})
        for (Vec3& p : *corners) p = {p.x * 0x1p10f, p.y * 0x1p10f, p.z * 0x1p10f};
    EXPECT_EQ(first_meeting(scaled.a, scaled.b), meeting);
  });
}

// The first time at which moving triangles meet, against exact positions at other times.

using detail::MovingPoints;

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

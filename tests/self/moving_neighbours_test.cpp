/// Moving triangles that share corners: against tests of their parts, against the test of posed
/// neighbours at many times, and in double against exact.
#include "self/neighbours.hpp"

#include "motion/moving_cases.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <optional>

namespace pelt::test {
namespace {

using detail::certainly_apart;
using detail::first_meeting;
using detail::first_meeting_of_neighbours;
using detail::FirstMeeting;
using detail::MovingSurfaceTriangle;
using detail::TriangleCorners;

struct NeighbourMotion {
  MovingSurfaceTriangle a, b;
};

/// Shares the first `count` corners.
NeighbourMotion share(MovingPair pair, std::size_t count) {
  NeighbourMotion motion = {{pair.a, {0, 1, 2}}, {pair.b, {3, 4, 5}}};
  for (std::size_t i = 0; i < count; ++i) {
    motion.b.vertices[i] = motion.a.vertices[i];
    motion.b.corners.from[i] = pair.a.from[i];
    motion.b.corners.to[i] = pair.a.to[i];
  }
  return motion;
}

MovingPair on_grid(Random& random, std::int64_t limit) {
  const MovingIntegers motion = grid_motion(random, limit);
  return {{scaled(motion.from.a, 0), scaled(motion.to.a, 0)},
          {scaled(motion.from.b, 0), scaled(motion.to.b, 0)}};
}

/// The part of a triangle between two of its corners.
MovingTriangle part(const MovingTriangle& t, std::size_t i, std::size_t k) {
  return {{t.from[i], t.from[k], t.from[i]}, {t.to[i], t.to[k], t.to[i]}};
}

std::optional<float> earlier(const std::optional<float>& time,
                             const std::optional<FirstMeeting>& meeting) {
  if (!meeting) return time;
  return time ? std::min(*time, meeting->time) : meeting->time;
}

std::optional<float> time_of(const std::optional<FirstMeeting>& meeting) {
  return earlier(std::nullopt, meeting);
}

/// Counts answers, and expects what must hold for all.
struct Tally {
  int at_start = 0, later = 0, never = 0, filtered = 0;

  std::optional<FirstMeeting> ask(const NeighbourMotion& motion) {
    const auto& [a, b] = motion;
    const auto meeting = first_meeting_of_neighbours(a, b);
    const bool is_filtered = certainly_apart(a, b);
    EXPECT_FALSE(is_filtered && meeting);
    const auto swapped = first_meeting_of_neighbours(b, a);
    EXPECT_EQ(time_of(swapped), time_of(meeting));
    EXPECT_EQ(meeting && meeting->at_start,
              detail::surface_triangles_intersect({a.corners.from, a.vertices},
                                                  {b.corners.from, b.vertices}));
    at_start += meeting && meeting->at_start;
    later += meeting && !meeting->at_start;
    never += !meeting;
    filtered += is_filtered;
    return meeting;
  }

  void print(std::uint64_t seed) const {
    std::cout << "seed " << seed << ": " << at_start << " at the start, " << later << " later, "
              << never << " never, of which " << filtered << " by the filter\n";
  }
};

TEST(MovingNeighbours, WithoutSharedCornersAreAnyTriangles) {
  Random random(701);
  Tally tally;
  for (int i = 0; i < 60; ++i) {
    const NeighbourMotion motion = share(on_grid(random, i % 2 ? 4 : 100), 0);
    EXPECT_EQ(tally.ask(motion), first_meeting(motion.a.corners, motion.b.corners));
  }
  tally.print(701);
  EXPECT_GT(tally.later, 10);
  EXPECT_GT(tally.never, 10);
}

TEST(MovingNeighbours, WithOneSharedCornerMeetByAnOppositeEdge) {
  Random random(702);
  Tally tally;
  for (int i = 0; i < 400; ++i) {
    const NeighbourMotion motion = share(on_grid(random, i % 3 == 0   ? 2
                                                         : i % 3 == 1 ? 9
                                                                      : 1000),
                                         1);
    const MovingTriangle &a = motion.a.corners, &b = motion.b.corners;
    const auto expected =
        earlier(time_of(first_meeting(part(a, 1, 2), b)), first_meeting(part(b, 1, 2), a));
    ASSERT_EQ(time_of(tally.ask(motion)), expected) << "pair " << i;
  }
  tally.print(702);
  EXPECT_GT(tally.at_start, 30);
  EXPECT_GT(tally.later, 100);
  EXPECT_GT(tally.never, 50);
  EXPECT_GT(tally.filtered, tally.never * 8 / 10);
}

/// Triangles in general position fold flat when a third corner is on the other triangle, or when
/// two edges cross that have no corner in common.
TEST(MovingNeighbours, WithTwoSharedCornersMeetWhenTheyFoldFlat) {
  Random random(703);
  Tally tally;
  for (int i = 0; i < 400; ++i) {
    const NeighbourMotion motion = share(on_grid(random, 1'000'000), 2);
    const MovingTriangle &a = motion.a.corners, &b = motion.b.corners;
    std::optional<float> expected;
    expected = earlier(expected, first_meeting(part(a, 2, 2), b));
    expected = earlier(expected, first_meeting(part(b, 2, 2), a));
    expected = earlier(expected, first_meeting(part(a, 0, 2), part(b, 1, 2)));
    expected = earlier(expected, first_meeting(part(a, 1, 2), part(b, 0, 2)));
    ASSERT_EQ(time_of(tally.ask(motion)), expected) << "pair " << i;
  }
  tally.print(703);
  EXPECT_GT(tally.later, 80);
  EXPECT_GT(tally.never, 80);
  EXPECT_GT(tally.filtered, tally.never * 8 / 10);
}

TriangleCorners at(const MovingTriangle& t, int k) {
  TriangleCorners corners;
  const auto move = [&](float from, float to) {
    return static_cast<float>(64 - k) * from + static_cast<float>(k) * to;
  };
  for (std::size_t i = 0; i < 3; ++i)
    corners[i] = {move(t.from[i].x, t.to[i].x), move(t.from[i].y, t.to[i].y),
                  move(t.from[i].z, t.to[i].z)};
  return corners;  // exact for small integers, 64 times as large
}

/// Between the times k / 64, the answer may contain more.
void expect_sampled_times(const NeighbourMotion& motion,
                          const std::optional<FirstMeeting>& meeting) {
  const auto& [a, b] = motion;
  for (int k = 0; k <= 64; ++k)
    if (detail::surface_triangles_intersect({at(a.corners, k), a.vertices},
                                            {at(b.corners, k), b.vertices})) {
      ASSERT_TRUE(meeting);
      ASSERT_LE(meeting->time, static_cast<float>(k) / 64);
    }
}

/// On a small grid, triangles collapse, slide in one plane, and coincide.
TEST(MovingNeighbours, MeetWheneverPosedNeighboursIntersect) {
  Random random(704);
  Tally tally;
  for (int i = 0; i < 1200; ++i) {
    MovingPair pair = on_grid(random, 1 + i % 3);
    if (i % 5 == 0)
      for (TriangleCorners* t : {&pair.a.from, &pair.a.to, &pair.b.from, &pair.b.to})
        for (Vec3& p : *t) p.z = 0;
    const NeighbourMotion motion = share(pair, 1 + random() % 2);
    expect_sampled_times(motion, tally.ask(motion));
  }
  tally.print(704);
  EXPECT_GT(tally.at_start, 200);
  EXPECT_GT(tally.later, 200);
  EXPECT_GT(tally.never, 100);
}

/// Corners with one surface vertex that are together only at an end of the step, or between.
TEST(MovingNeighbours, ShareACornerOnlyWhileItIsAtOnePosition) {
  Random random(705);
  Tally tally;
  for (int i = 0; i < 600; ++i) {
    NeighbourMotion motion = share(on_grid(random, 3), 2);
    auto& [from, to] = motion.b.corners;
    switch (random() % 3) {
      case 0:
        from[0] = from[2];
        break;
      case 1:
        to[0] = to[2];
        break;
      default:
        from[0] = motion.a.corners.to[0], to[0] = motion.a.corners.from[0];  // meet at half time
    }
    expect_sampled_times(motion, tally.ask(motion));
  }
  tally.print(705);
  EXPECT_GT(tally.later, 100);
  EXPECT_GT(tally.never, 20);
}

/// Two triangles of a plane that open like a book: they overlap before, and touch only in the
/// shared edge after the instant at which one has collapsed to it.
TEST(MovingNeighbours, MayOverlapAtAllTimesButTheFirst) {
  const TriangleCorners still = {{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}};
  const TriangleCorners collapsed = {{{0, 0, 0}, {4, 0, 0}, {8, 0, 0}}};
  const TriangleCorners overlapping = {{{0, 0, 0}, {4, 0, 0}, {8, 4, 0}}};
  const NeighbourMotion motion = {{{still, still}, {0, 1, 2}},
                                  {{collapsed, overlapping}, {0, 1, 3}}};
  const auto meeting = first_meeting_of_neighbours(motion.a, motion.b);
  ASSERT_TRUE(meeting);
  EXPECT_FALSE(meeting->at_start);
  EXPECT_EQ(meeting->time, 0);
}

TEST(MovingNeighbours, OfADuplicateIntersectAtTheStart) {
  Random random(706);
  const NeighbourMotion motion = share(on_grid(random, 50), 3);
  const auto meeting = first_meeting_of_neighbours(motion.a, motion.b);
  ASSERT_TRUE(meeting);
  EXPECT_TRUE(meeting->at_start);
}

}  // namespace
}  // namespace pelt::test

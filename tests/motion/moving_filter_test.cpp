/// The certified test of one pair of moving triangles against the exact one. The environment
/// variable PELT_MOVING_PAIRS sets the number of pairs per family.

#include "motion/moving_filter.hpp"
#include "motion/meeting_order.hpp"
#include "motion/moving_floats.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <optional>
#include <ostream>
#include <vector>

namespace pelt::test {
namespace {

using detail::CertainAnswer;
using detail::FirstMeeting;

struct Case {
  const char* name;
  MovingPair (*make)(Random&);
  double most_unknown = 1;  ///< shares of pairs: of answers, and of first meetings
  double most_not_found = 1;

  friend void PrintTo(const Case& tested, std::ostream* out) { *out << tested.name; }
};

constexpr Case kCases[] = {
    {"CloseAt1", close_at_1, 0.001, 0.001},
    {"CloseAt1000", close_at_1000, 0.001, 0.001},
    {"Slow", slow, 0.001, 0.001},
    {"BesideAStillOne", beside_a_still_one, 0.001, 0.001},
    {"PassingThreeTimes", passing_three_times, 0.01, 0.01},
    {"Large", of_size<59>, 0.001, 0.002},
    {"Small", of_size<-120>, 0.001, 0.002},
    {"AllMagnitudes", of_all_magnitudes},
    {"SmallGrid", moving_integers<on_small_grid>, 0.2, 0.2},
    {"MediumGrid", moving_integers<on_medium_grid>, 0.01, 0.01},
    {"LargeGrid", moving_integers<on_large_grid>, 0.001, 0.002},
    {"StillPlane", moving_integers<in_still_plane>},
    {"TurningPlane", moving_integers<in_turning_plane>},
    {"StillCorners", moving_integers<with_still_corners>, 0.15, 0.15},
    {"AlwaysCollapsed", moving_integers<always_collapsed>},
    {"OnLine", moving_integers<on_line>},
    {"Sliding", moving_integers<sliding>},
    {"Swapping", moving_integers<swapping>},
    {"NearlyMeeting", moving_integers<nearly_meeting>, 0.25, 0.3},
    {"OneUlpFromMeeting", one_ulp_from_meeting, 0.25, 0.3},
    {"PointsPassing", points_passing},
    {"LandingOnAnEdge", moving_integers<landing_on_an_edge>, 0.05, 0.9},
    {"Grazing", moving_integers<grazing>},
};

int pairs_per_family() {
  const char* text = std::getenv("PELT_MOVING_PAIRS");
  return text == nullptr ? 800 : std::atoi(text);
}

class MovingFilter : public testing::TestWithParam<Case> {};

TEST_P(MovingFilter, DecidesAsTheExactTest) {
  constexpr std::uint64_t kSeed = 195;
  const int pairs = pairs_per_family();
  Random random(kSeed);
  int unknown = 0, not_found = 0, met = 0;
  for (int i = 0; i < pairs; ++i) {
    const MovingPair pair = GetParam().make(random);
    const auto expected = detail::first_meeting(pair.a, pair.b);
    const CertainAnswer answer = detail::certainly_intersect(pair.a, pair.b);
    if (answer == CertainAnswer::unknown) {
      ++unknown;
    } else {
      ASSERT_EQ(answer == CertainAnswer::yes, expected.has_value()) << to_text(pair);
    }
    std::optional<FirstMeeting> meeting;
    if (detail::find_certain_first_meeting(pair.a, pair.b, meeting)) {
      ASSERT_EQ(meeting, expected) << to_text(pair);
      met += meeting && !meeting->at_start;
    } else {
      ++not_found;
    }
  }
  std::cout << "seed " << kSeed << ": " << pairs << " pairs, " << unknown << " unknown; of first "
            << "meetings, " << not_found << " not found, " << met << " after the start\n";
  EXPECT_LE(unknown, GetParam().most_unknown * pairs);
  EXPECT_LE(not_found, GetParam().most_not_found * pairs);
  EXPECT_TRUE(met > pairs / 100 || GetParam().most_unknown == 1);
}

INSTANTIATE_TEST_SUITE_P(All, MovingFilter, testing::ValuesIn(kCases),
                         [](const auto& tested) { return std::string(tested.param.name); });

// The order of first times against the exact one.

using detail::MeetingPair;

/// The pairs of two sets of moving triangles that meet after the start.
std::vector<MeetingPair> meeting_pairs(const std::vector<detail::MovingTriangle>& a,
                                       const std::vector<detail::MovingTriangle>& b) {
  std::vector<MeetingPair> pairs;
  for (const auto& s : a)
    for (const auto& r : b)
      if (const auto first = detail::first_meeting(s, r); first && !first->at_start)
        pairs.push_back({s, r, *first});
  return pairs;
}

/// Triangles around corner 0 of a triangle.
std::vector<detail::MovingTriangle> fan_around(Random& random, detail::MovingTriangle triangle) {
  std::vector<detail::MovingTriangle> fan = {triangle};
  for (int i = 0; i < 3; ++i) {
    triangle.from[1] = triangle.from[2], triangle.to[1] = triangle.to[2];
    triangle.from[2] = near(random, triangle.from[0], 0.01f);
    triangle.to[2] = near(random, triangle.to[0], 0.01f);
    fan.push_back(triangle);
  }
  return fan;
}

int exact_order(const MeetingPair& p, const MeetingPair& q) {
  if (p.first.time == 1 || q.first.time == 1)
    return p.first.time == q.first.time ? 0 : p.first.time < q.first.time ? -1 : 1;
  return detail::first_time_of(p.a, p.b).compare(detail::first_time_of(q.a, q.b));
}

TEST(MeetingOrder, IsTheExactOneOfFans) {
  constexpr std::uint64_t kSeed = 1830;
  Random random(kSeed);
  int equal = 0, different = 0;
  for (int round = 0; round < 200; ++round) {
    const MovingPair pair = close_at_1(random);
    const auto pairs = meeting_pairs(fan_around(random, pair.a), fan_around(random, pair.b));
    for (std::size_t i = 0; i + 1 < pairs.size(); ++i) {
      const int order = detail::compare_first_times(pairs[i], pairs[i + 1]);
      EXPECT_EQ(order, exact_order(pairs[i], pairs[i + 1]));
      EXPECT_EQ(order, -detail::compare_first_times(pairs[i + 1], pairs[i]));
      ++(order == 0 ? equal : different);
    }
  }
  std::printf("seed %d: %d equal times, %d different ones\n", static_cast<int>(kSeed), equal,
              different);
  EXPECT_GT(equal, 20);
  EXPECT_GT(different, 20);
}

/// Two corners that reach a still plane at the same time, and one that reaches it earlier, at a
/// time with the same float.
TEST(MeetingOrder, DistinguishesTimesWithTheSameFloat) {
  const auto corner_at = [](float x, float from, float to) {
    const Vec3 start = {x, 0, from}, end = {x, 0, to};
    return detail::MovingTriangle{{start, start, start}, {end, end, end}};
  };
  const detail::TriangleCorners square = {Vec3{-9, -9, 0}, Vec3{9, -9, 0}, Vec3{0, 9, 0}};
  const detail::MovingTriangle plane = {square, square};
  const auto meeting = [&](const detail::MovingTriangle& corner) {
    return MeetingPair{corner, plane, *detail::first_meeting(corner, plane)};
  };
  const MeetingPair first = meeting(corner_at(0, 1, -0.5f));
  const MeetingPair same = meeting(corner_at(1, 2, -1));
  const MeetingPair earlier = meeting(corner_at(2, 1, -0x1.000002p-1f));
  ASSERT_EQ(first.first.time, same.first.time);
  ASSERT_EQ(first.first.time, earlier.first.time);
  EXPECT_EQ(detail::compare_first_times(first, same), 0);
  EXPECT_EQ(detail::compare_first_times(first, earlier), 1);
  EXPECT_EQ(detail::compare_first_times(earlier, same), -1);
}

/// Four corners that are coplanar twice, at 1/3 - d and 1/3 + d with d = 2^-26 / 3: their
/// determinant is (3t - 1)^2 - 2^-52 up to a factor. At the first of these times, one of them is
/// inside the triangle of the others; at the second, it is outside, and the segments of two each
/// cross. Both times have the same float.
TEST(MeetingOrder, DistinguishesTwoRootsOfOneDeterminant) {
  const Vec3 left = {-4, 0, 0}, right = {4, 0, 0};
  const Vec3 below_from = {0, -4, -4}, below_to = {0, -4, 8};
  const Vec3 corner_from = {0, -1, -0x1p-52f}, corner_to = {0, 2, -0x1p-52f};
  const detail::MovingTriangle corner = {{{corner_from, corner_from, corner_from}},
                                         {{corner_to, corner_to, corner_to}}};
  const detail::MovingTriangle face = {{{left, right, below_from}}, {{left, right, below_to}}};
  const detail::MovingTriangle edge = {{{corner_from, below_from, below_from}},
                                       {{corner_to, below_to, below_to}}};
  const detail::MovingTriangle still_edge = {{{left, right, right}}, {{left, right, right}}};
  const MeetingPair first = {corner, face, *detail::first_meeting(corner, face)};
  const MeetingPair second = {edge, still_edge, *detail::first_meeting(edge, still_edge)};
  ASSERT_EQ(first.first.time, second.first.time);
  EXPECT_EQ(detail::compare_first_times(first, second), -1);
  EXPECT_EQ(detail::compare_first_times(second, first), 1);
}

}  // namespace
}  // namespace pelt::test

/// The certified test of one pair of moving triangles against the exact one. The environment
/// variable PELT_MOVING_PAIRS sets the number of pairs per family.
#include "motion/moving_filter.hpp"

#include "moving_floats.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <optional>
#include <ostream>

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

}  // namespace
}  // namespace pelt::test

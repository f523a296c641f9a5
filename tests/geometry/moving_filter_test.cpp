/// The certified test of one pair of moving triangles against the exact one.
#include "geometry/moving_filter.hpp"

#include "moving_floats.hpp"

#include <gtest/gtest.h>

#include <cstdint>
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
    {"CloseAt1", close_at_1, 0.001, 0.002},
    {"CloseAt1000", close_at_1000, 0.001, 0.002},
    {"Slow", slow, 0.001, 0.002},
    {"BesideAStillOne", beside_a_still_one, 0.001, 0.002},
    {"Large", of_size<59>, 0.001, 0.002},
    {"Small", of_size<-120>, 0.02, 0.02},
    {"AllMagnitudes", of_all_magnitudes},
    {"SmallGrid", moving_integers<on_small_grid>},
    {"MediumGrid", moving_integers<on_medium_grid>, 0.2, 0.3},
    {"LargeGrid", moving_integers<on_large_grid>, 0.01, 0.01},
    {"StillPlane", moving_integers<in_still_plane>},
    {"TurningPlane", moving_integers<in_turning_plane>},
    {"StillCorners", moving_integers<with_still_corners>},
    {"AlwaysCollapsed", moving_integers<always_collapsed>},
    {"OnLine", moving_integers<on_line>},
    {"Sliding", moving_integers<sliding>},
    {"Swapping", moving_integers<swapping>},
    {"NearlyMeeting", moving_integers<nearly_meeting>, 0.6, 0.6},
    {"Grazing", moving_integers<grazing>},
};

class MovingFilter : public testing::TestWithParam<Case> {};

TEST_P(MovingFilter, DecidesAsTheExactTest) {
  constexpr std::uint64_t kSeed = 195;
  constexpr int kPairs = 800;
  Random random(kSeed);
  int unknown = 0, not_found = 0, met = 0;
  for (int i = 0; i < kPairs; ++i) {
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
  std::cout << "seed " << kSeed << ": " << kPairs << " pairs, " << unknown << " unknown; of first "
            << "meetings, " << not_found << " not found, " << met << " after the start\n";
  EXPECT_LE(unknown, GetParam().most_unknown * kPairs);
  EXPECT_LE(not_found, GetParam().most_not_found * kPairs);
  EXPECT_TRUE(met > kPairs / 100 || GetParam().most_unknown == 1);
}

INSTANTIATE_TEST_SUITE_P(All, MovingFilter, testing::ValuesIn(kCases),
                         [](const auto& tested) { return std::string(tested.param.name); });

}  // namespace
}  // namespace pelt::test

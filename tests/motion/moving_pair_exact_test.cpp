/// The exact test of moving triangles against an independent method with numbers of GMP. The
/// environment variable PELT_MOVING_PAIRS sets the number of pairs per family.
#include "motion/moving_pair.hpp"

#include "geometry/triangle_pair.hpp"
#include "moving_cases.hpp"
#include "moving_oracle.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <optional>

namespace pelt::test {
namespace {

using detail::FirstMeeting;

int pairs_per_family() {
  const char* text = std::getenv("PELT_MOVING_PAIRS");
  return text == nullptr ? 100 : std::atoi(text);
}

std::string to_text(const Feature& feature) {
  constexpr const char* kNames[] = {"corner ", "edge ", "face "};
  return kNames[static_cast<int>(feature.kind)] + std::to_string(feature.number);
}

std::string to_text(const std::optional<FirstMeeting>& meeting) {
  if (!meeting) return "never";
  if (meeting->at_start) return "at the start";
  return std::to_string(meeting->time) + ", " + to_text(meeting->a) + " and " + to_text(meeting->b);
}

class MovingPairExact : public testing::TestWithParam<MovingFamily> {};

TEST_P(MovingPairExact, MeetsAsByAnIndependentMethod) {
  constexpr std::uint64_t kSeed = 181;
  const int pairs = pairs_per_family();
  Random random(kSeed);
  int at_start = 0, later = 0;
  for (int i = 0; i < pairs; ++i) {
    const MovingPair pair = GetParam().make(random);
    const auto expected = MovingOracle(pair.a, pair.b).first_meeting();
    const auto meeting = detail::first_meeting(pair.a, pair.b);
    ASSERT_EQ(meeting, expected) << to_text(meeting) << " instead of " << to_text(expected)
                                 << ", pair " << i << " of seed " << kSeed << ": " << to_text(pair);
    ASSERT_EQ(meeting && meeting->at_start, detail::triangles_intersect(pair.a.from, pair.b.from));
    ASSERT_TRUE(meeting || !detail::triangles_intersect(pair.a.to, pair.b.to));
    at_start += meeting && meeting->at_start;
    later += meeting && !meeting->at_start;
  }
  EXPECT_GE(later, GetParam().least_hits * pairs);
  EXPECT_LE(at_start + later, GetParam().most_hits * pairs);
}

INSTANTIATE_TEST_SUITE_P(Families, MovingPairExact, testing::ValuesIn(kMovingFamilies),
                         [](const auto& family) { return std::string(family.param.name); });

}  // namespace
}  // namespace pelt::test

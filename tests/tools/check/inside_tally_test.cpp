#include "tools/pelt/check/tallies.hpp"

#include <gtest/gtest.h>

namespace pelt::tools::check {
namespace {

InsidePair contained(std::uint32_t a, std::uint32_t b, Containment containment) {
  return {.a = a, .b = b, .containment = containment};
}

TEST(InsideTally, CountsTheFramesOfEachContainedBody) {
  InsideTally tally;
  const std::vector<InsidePair> both = {contained(0, 1, Containment::a_in_b),
                                        contained(0, 2, Containment::b_in_a)};
  tally.add(3, both);
  tally.add(4, {});
  tally.add(5, std::span(both).last(1));
  tally.add(6, std::vector{contained(0, 2, Containment::a_in_b)});
  ASSERT_EQ(tally.held.size(), 3u);
  EXPECT_EQ(tally.held[0].inner, 0u);
  EXPECT_EQ(tally.held[0].outer, 1u);
  EXPECT_EQ(tally.held[0].frames, 1u);
  EXPECT_EQ(tally.held[1].inner, 2u);
  EXPECT_EQ(tally.held[1].outer, 0u);
  EXPECT_EQ(tally.held[1].frames, 2u);
  EXPECT_EQ(tally.held[1].first_frame, 3u);
  EXPECT_EQ(tally.held[2].inner, 0u);
  EXPECT_EQ(tally.held[2].first_frame, 6u);
  EXPECT_EQ(tally.frames_held, (std::vector<std::uint32_t>{3, 5, 6}));
}

TEST(InsideTally, CountsEachTakeByItself) {
  InsideTally tally;
  const std::vector<InsidePair> pair = {contained(0, 1, Containment::a_in_b)};
  tally.add(3, pair, 0);
  tally.add(4, pair, 1);
  tally.add(5, pair, 1);
  ASSERT_EQ(tally.held.size(), 2u);
  EXPECT_EQ(tally.held[0].take, 0u);
  EXPECT_EQ(tally.held[0].frames, 1u);
  EXPECT_EQ(tally.held[1].take, 1u);
  EXPECT_EQ(tally.held[1].first_frame, 4u);
  EXPECT_EQ(tally.held[1].frames, 2u);
}

/// Comparing all bodies with each other would take 10^11 steps, which is minutes.
TEST(InsideTally, CountsInTimeLinearInBodies) {
  std::vector<InsidePair> pairs;
  for (std::uint32_t b = 1; b <= 800'000; ++b)
    pairs.push_back(contained(0, b, Containment::b_in_a));
  InsideTally tally;
  tally.add(0, pairs);
  tally.add(1, pairs);
  ASSERT_EQ(tally.held.size(), pairs.size());
  EXPECT_EQ(tally.held.back().inner, 800'000u);
  EXPECT_EQ(tally.held.back().frames, 2u);
}

}  // namespace
}  // namespace pelt::tools::check

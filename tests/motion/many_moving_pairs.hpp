#pragma once

/// Pairs of moving triangles of many families, with their first meetings.

#include "motion/moving_pair.hpp"
#include "moving_floats.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <iostream>

namespace pelt::test {

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

}  // namespace pelt::test

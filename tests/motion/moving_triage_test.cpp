/// The certified test of eight pairs of moving triangles against the exact one.
#include "motion/moving_triage.hpp"

#include <pelt/config.hpp>

#include "base/hash.hpp"
#include "motion/moving_pair.hpp"
#include "moving_floats.hpp"
#include "moving_lanes.hpp"
#include "support/instruction_sets.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <iostream>
#include <ostream>
#include <string>

namespace pelt::test {
namespace {

using detail::TriangleCorners;

struct Case {
  const char* name;
  MovingPair (*make)(Random&);
  double least_undecided, most_undecided;  ///< shares of pairs
  double least_intersecting;               ///< share of the decided pairs

  friend void PrintTo(const Case& tested, std::ostream* out) { *out << tested.name; }
};

constexpr Case kCases[] = {
    {"CloseAt1", close_at_1, 0, 0.02, 0.05},
    {"CloseAt1000", close_at_1000, 0, 0.02, 0.05},
    {"Slow", slow, 0, 0.01, 0.1},
    {"BesideAStillOne", beside_a_still_one, 0, 0.02, 0.05},
    {"Large", of_size<30>, 0, 0.4, 0.1},
    {"LargestProducts", of_size<41>, 0.1, 1, 0},
    {"Overflowing", of_size<59>, 0.5, 1, 0},
    {"Small", of_size<-20>, 0, 0.4, 0.1},
    {"SmallestProducts", of_size<-25>, 0.05, 0.95, 0.01},
    {"Underflowing", of_size<-50>, 0.5, 1, 0},
    {"AllMagnitudes", of_all_magnitudes, 0.3, 1, 0},
    {"SmallGrid", moving_integers<on_small_grid>, 0.1, 0.95, 0.01},
    {"MediumGrid", moving_integers<on_medium_grid>, 0.01, 0.95, 0.01},
    {"LargeGrid", moving_integers<on_large_grid>, 0.01, 0.95, 0.01},
    {"StillPlane", moving_integers<in_still_plane>, 0.9, 1, 0},
    {"StillCorners", moving_integers<with_still_corners>, 0.1, 0.95, 0.01},
    {"AlwaysCollapsed", moving_integers<always_collapsed>, 0.1, 1, 0},
    {"Sliding", moving_integers<sliding>, 0.1, 1, 0},
    {"Swapping", moving_integers<swapping>, 0.1, 1, 0},
    {"NearlyMeeting", moving_integers<nearly_meeting>, 0.01, 0.95, 0.01},
    {"Grazing", moving_integers<grazing>, 0.1, 1, 0},
    {"PointsPassing", points_passing, 0.4, 1, 0},
};

constexpr Compiled<MovingTriageLanes> kTriage[] = PELT_ALL_COMPILED(moving_triage_lanes);

void put(const TriangleCorners& triangle, float (&corners)[3][8][4], std::size_t lane) {
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3& p = triangle[i];
    const float values[4] = {p.x, p.y, p.z, 0};
    std::copy_n(values, 4, corners[i][lane]);
  }
}

/// Eight pairs from a generator.
struct Batch {
  std::array<MovingPair, 8> pairs;
  MovingLanes lanes;

  Batch(Random& random, MovingPair (*make)(Random&)) {
    for (std::size_t lane = 0; lane < 8; ++lane) {
      pairs[lane] = make(random);
      put(pairs[lane].a.from, lanes.from[0], lane);
      put(pairs[lane].b.from, lanes.from[1], lane);
      put(pairs[lane].a.to, lanes.to[0], lane);
      put(pairs[lane].b.to, lanes.to[1], lane);
    }
  }
};

struct Tally {
  int pairs = 0, apart = 0, intersecting = 0;

  void add(const MovingPair& pair, bool is_apart, bool is_intersecting) {
    ++pairs;
    apart += is_apart;
    intersecting += is_intersecting;
    const bool meet = detail::first_meeting(pair.a, pair.b).has_value();
    EXPECT_FALSE(is_apart && meet) << to_text(pair);
    EXPECT_FALSE(is_intersecting && !meet) << to_text(pair);
  }
};

class MovingTriage : public testing::TestWithParam<Case> {};

TEST_P(MovingTriage, DecidesAsTheExactTest) {
  constexpr std::uint64_t kSeed = 191;
  Random random(kSeed);
  Tally tally;
  for (int i = 0; i < 100 && !HasFailure(); ++i) {
    const Batch batch(random, GetParam().make);
    const LaneMasks masks = on_each_compiled(kTriage, batch.lanes);
    for (std::size_t lane = 0; lane < 8; ++lane)
      tally.add(batch.pairs[lane], masks.apart >> lane & 1, masks.intersecting >> lane & 1);
  }
  const int decided = tally.apart + tally.intersecting;
  const double undecided = 1 - 1.0 * decided / tally.pairs;
  std::cout << "seed " << kSeed << ": " << tally.pairs << " pairs, " << tally.apart << " apart, "
            << tally.intersecting << " intersect, " << 100 * undecided << " % undecided\n";
  EXPECT_GE(undecided, GetParam().least_undecided);
  EXPECT_LE(undecided, GetParam().most_undecided);
  EXPECT_GE(tally.intersecting, GetParam().least_intersecting * decided);
}

INSTANTIATE_TEST_SUITE_P(All, MovingTriage, testing::ValuesIn(kCases),
                         [](const auto& tested) { return std::string(tested.param.name); });

TEST(MovingTriageMasks, AreTheSameForEveryTargetAndCompiler) {
  constexpr std::uint64_t kGolden = 0xcffe9c1081ca7f90u;
  for (const auto& [set, triage] : kTriage) {
    if (!runs_here(set)) continue;
    Random random(192);
    detail::Fnv1a64 hash;
    for (int i = 0; i < 2'000; ++i) {
      for (const auto make : {close_at_1, close_at_1000, slow, of_size<41>, of_size<-25>}) {
        const LaneMasks masks = triage(Batch(random, make).lanes);
        hash.add_u32(masks.apart << 8 | masks.intersecting);
      }
    }
    EXPECT_EQ(hash.value(), kGolden) << name_of(set);
  }
}

}  // namespace
}  // namespace pelt::test

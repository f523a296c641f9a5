/// The promises of a search for the first contact after any amount of work, against brute force.

#include <pelt/search.hpp>

#include "collide/moving_search_bodies.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace pelt::test {
namespace {

/// All contacts that count, and the first.
struct MovingTruth {
  MovingTruth(Body& a, Body& b, bool leave_out_start)
      : contacts(brute_force(a, b)), first(first_of(a, b, leave_out_start)) {
    if (leave_out_start) std::erase_if(contacts, [](const MovingContact& c) { return c.at_start; });
    for (const MovingContact& c : contacts) time = std::min(time, c.time);
  }

  std::vector<MovingContact> contacts;
  std::optional<MovingContact> first;
  float time = 2;  ///< of the first contact; 2 if there is none
};

/// Compares a search with the truth and with its own earlier state.
class TimeLadder {
 public:
  TimeLadder(const MovingTruth& truth, const FirstContactSearch& search)
      : truth_(truth), search_(search) {}

  void check_rung() {
    const float apart = search_.apart_until();
    const std::optional<MovingContact> earliest = search_.earliest();
    ASSERT_GE(apart, apart_);
    ASSERT_LE(apart, truth_.time);
    ASSERT_LE(apart, 1);
    ASSERT_TRUE(earliest || !earliest_);
    if (earliest) {
      ASSERT_LE(apart, earliest->time);
      ASSERT_NE(std::find(truth_.contacts.begin(), truth_.contacts.end(), *earliest),
                truth_.contacts.end());
      ASSERT_LE(earliest->time, earliest_ ? earliest_->time : 1);
    }
    ASSERT_EQ(search_.verdict(), earliest                ? Verdict::touching
                                 : search_.is_complete() ? Verdict::apart
                                                         : Verdict::unknown);
    between += apart > 0 && apart < truth_.time;
    improved += earliest_ && earliest_ != earliest;
    apart_ = apart;
    earliest_ = earliest;
  }

  void check_end() const {
    ASSERT_EQ(search_.earliest(), truth_.first);
    ASSERT_EQ(search_.earliest().has_value(), !truth_.contacts.empty());
    ASSERT_EQ(search_.apart_until(), std::min(truth_.time, 1.0f));
  }

  std::size_t between = 0;   ///< rungs with a lower bound between 0 and the first time
  std::size_t improved = 0;  ///< rungs with an earlier contact than the former

 private:
  const MovingTruth& truth_;
  const FirstContactSearch& search_;
  float apart_ = 0;
  std::optional<MovingContact> earliest_;
};

struct Hits {
  std::size_t at_start = 0, later = 0, apart = 0, rungs = 0, between = 0, improved = 0;

  void add(const MovingTruth& truth) {
    ++(!truth.first ? apart : truth.first->at_start ? at_start : later);
  }
};

/// Runs a search with budgets 1, 2, 4, ...
void climb(Body& a, Body& b, const MovingTruth& truth, bool leave_out_start, std::uint32_t max_open,
           Hits& hits) {
  FirstContactSearch search(a.step(), b.step(), {leave_out_start}, max_open);
  TimeLadder ladder(truth, search);
  ASSERT_NO_FATAL_FAILURE(ladder.check_rung());
  for (std::uint64_t work = 1; !search.is_complete(); work *= 2, ++hits.rungs) {
    search.advance(work);
    ASSERT_NO_FATAL_FAILURE(ladder.check_rung());
  }
  ASSERT_NO_FATAL_FAILURE(ladder.check_end());
  hits.between += ladder.between;
  hits.improved += ladder.improved;
}

TEST(FirstContactPromises, HoldAfterAnyAmountOfWork) {
  Random random(650);
  Hits hits;
  for_moving_bodies(random, 16, 60, [&](Body& a, Body& b) {
    for (const bool leave_out_start : {false, true}) {
      const MovingTruth truth(a, b, leave_out_start);
      hits.add(truth);
      for (const std::uint32_t max_open : {FirstContactSearch::kMaxOpen, 3u, 0u})
        ASSERT_NO_FATAL_FAILURE(climb(a, b, truth, leave_out_start, max_open, hits));
    }
  });
  std::printf(
      "seed 650: %zu at the start, %zu later, %zu never, %zu rungs, %zu between, %zu improved\n",
      hits.at_start, hits.later, hits.apart, hits.rungs, hits.between, hits.improved);
  EXPECT_GT(hits.at_start, 5u);
  EXPECT_GT(hits.later, 10u);
  EXPECT_GT(hits.apart, 1u);
  EXPECT_GT(hits.between, 20u);
  EXPECT_GT(hits.improved, 5u);
}

/// Boxes of nodes that are opened on demand do not nest, so parts may seem to overlap earlier than
/// the whole.
TEST(FirstContactPromises, TheLowerBoundNeverFalls) {
  Random random(651);
  Limbs limbs = {Body(make_limb(60, 24, 4)), Body(make_limb(40, 20, 3))};
  std::size_t rises = 0;
  for (int round = 0; round < 60; ++round) {
    move_past(random, limbs);
    FirstContactSearch search(limbs.a.step(), limbs.b.step());
    float former = search.apart_until();
    while (!search.is_complete()) {
      search.advance(1);
      ASSERT_GE(search.apart_until(), former) << "round " << round;
      rises += search.apart_until() > former;
      former = search.apart_until();
    }
  }
  EXPECT_GT(rises, 200u);
}

/// Parallel sheets, tilted so that their boxes overlap, that approach each other. Only one vertex
/// reaches the other sheet, and each vertex is the one in turn.
TEST(FirstContactPromises, TheFirstContactMayBeAtAnyVertex) {
  constexpr std::uint32_t kCells = 6;
  const auto raised = [](float by) {
    return sheet_positions(kCells, [by](std::uint32_t x, std::uint32_t y) {
      return static_cast<float>(x + 2 * y) + by;
    });
  };
  Body below(make_sheet(kCells)), above(make_sheet(kCells));
  below.move(pin(raised(0)), pin(raised(0)));
  Hits hits;
  for (std::size_t ahead = 1; ahead < raised(0).size(); ahead += 3) {
    std::vector<Vec3> first = raised(1), last = raised(0.25f);
    first[ahead].z -= 0.25f;
    last[ahead].z -= 0.5f;
    above.move(pin(first), pin(last));
    const MovingTruth truth(below, above, false);
    hits.add(truth);
    EXPECT_EQ(truth.time, 0.75f);
    for (const std::uint32_t max_open : {FirstContactSearch::kMaxOpen, 3u})
      ASSERT_NO_FATAL_FAILURE(climb(below, above, truth, false, max_open, hits));
  }
  EXPECT_GT(hits.later, 15u);
}

/// Such sheets, but a part of the upper one flies away early, so boxes of its parts overlap until
/// different times.
TEST(FirstContactPromises, TheFirstContactMayBeAfterOtherPartsHaveLeft) {
  constexpr std::uint32_t kCells = 12;
  const auto tilted = [](float by) {
    return sheet_positions(kCells, [by](std::uint32_t x, std::uint32_t y) {
      return static_cast<float>(x + 2 * y) + by;
    });
  };
  Body below(make_sheet(kCells)), above(make_sheet(kCells));
  below.move(pin(tilted(0)), pin(tilted(0)));
  for (const bool stays_low : {false, true})
    for (std::uint32_t border = 1; border < kCells; ++border) {
      std::vector<Vec3> first = tilted(1), last = tilted(0.25f);
      for (Vec3& p : last)
        if ((p.y < static_cast<float>(border)) != stays_low) p.z += 200;
      const std::size_t ahead = (stays_low ? border - 1 : border) * (kCells + 1) + kCells / 2;
      first[ahead].z -= 0.25f;
      last[ahead].z -= 0.5f;
      above.move(pin(first), pin(last));
      FirstContactSearch search(below.step(), above.step());
      search.advance(UINT64_MAX);
      ASSERT_TRUE(search.earliest()) << border;
      EXPECT_EQ(search.earliest()->time, 0.75f);
      EXPECT_EQ(search.earliest(), first_of(below, above, false));
    }
}

/// The corner of a sheet and a vertex that passes it in the plane of the sheet: they touch at one
/// instant.
TEST(FirstContactPromises, HoldForContactAtOneInstant) {
  constexpr std::uint32_t kCells = 6;
  const std::vector<Vec3> flat =
      sheet_positions(kCells, [](std::uint32_t, std::uint32_t) { return 0.0f; });
  Body still(make_sheet(kCells)), passing(make_sheet(kCells));
  still.move(pin(flat), pin(flat));
  Hits hits;
  for (std::size_t tip = 0; tip < flat.size(); tip += 3) {
    const auto passing_at = [&](float x, float y) {
      std::vector<Vec3> positions = flat;
      for (Vec3& p : positions) p = {0.25f * p.x + x, 0.25f * p.y + y, 1};
      positions[tip] = {x, y, 0};
      return pin(positions);
    };
    passing.move(passing_at(-1, 1), passing_at(1, -1));
    const MovingTruth truth(still, passing, false);
    ASSERT_EQ(truth.time, 0.5f);
    hits.add(truth);
    for (const std::uint32_t max_open : {FirstContactSearch::kMaxOpen, 3u})
      ASSERT_NO_FATAL_FAILURE(climb(still, passing, truth, false, max_open, hits));
  }
  EXPECT_GT(hits.later, 10u);
}

}  // namespace
}  // namespace pelt::test

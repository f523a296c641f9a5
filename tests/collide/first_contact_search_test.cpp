#include <pelt/search.hpp>

#include "base/bits.hpp"
#include "base/hash.hpp"
#include "collide/first_contact_search.hpp"
#include "collide/moving_search_bodies.hpp"
#include "support/allocation_count.hpp"
#include "support/instruction_sets.hpp"

#include <gtest/gtest.h>

#include <map>

namespace pelt::test {
namespace {

constexpr std::uint64_t kUnlimited = UINT64_MAX;

/// Two limbs. The second moves along x, from one place to another.
struct PassingLimbs {
  Body a = Body(make_limb(24, 10, 5)), b = Body(make_limb(17, 9, 4));

  PassingLimbs(float from, float to) {
    a.move(at(5, 0), at(5, 0));
    b.move(at(4, from), at(4, to));
  }

  static std::vector<Matrix4> at(std::uint32_t joints, float x) {
    Random random(640);
    return bend_limb(random, joints, 0.3, {x, 0, 0});
  }
};

TEST(FirstContactSearch, StartsUnknownAndEndsTouching) {
  PassingLimbs limbs(-1, 1);
  FirstContactSearch search(limbs.a.step(), limbs.b.step());
  EXPECT_EQ(search.verdict(), Verdict::unknown);
  EXPECT_EQ(search.apart_until(), 0);
  EXPECT_FALSE(search.earliest());
  const MovingStats stats = search.advance(kUnlimited);
  EXPECT_FALSE(stats.cut_short);
  EXPECT_GT(stats.double_pairs, 0u);
  EXPECT_TRUE(search.is_complete());
  EXPECT_EQ(search.verdict(), Verdict::touching);
  const auto first = first_of(limbs.a, limbs.b, false);
  ASSERT_TRUE(first);
  EXPECT_FALSE(first->at_start);
  EXPECT_EQ(search.earliest(), first);
  EXPECT_EQ(search.apart_until(), first->time);
}

TEST(FirstContactSearch, KnowsMoreAfterHalfOfTheWork) {
  PassingLimbs limbs(-1, 1);
  FirstContactSearch search(limbs.a.step(), limbs.b.step());
  search.advance(kUnlimited);
  const std::uint64_t all = search.work_done();
  const float time = search.earliest()->time;
  search.restart();
  const MovingStats stats = search.advance(all / 2);
  EXPECT_TRUE(stats.cut_short);
  EXPECT_GT(search.apart_until(), 0.5f * time);
  EXPECT_LE(search.apart_until(), time);
}

TEST(FirstContactSearch, DistantBodiesAreApartAtOnce) {
  PassingLimbs limbs(4, 5);
  const FirstContactSearch search(limbs.a.step(), limbs.b.step());
  EXPECT_TRUE(search.is_complete());
  EXPECT_EQ(search.verdict(), Verdict::apart);
  EXPECT_EQ(search.apart_until(), 1);
  EXPECT_FALSE(search.earliest());
}

TEST(FirstContactSearch, TakesAboutTheWorkOfFirstContact) {
  PassingLimbs limbs(-1, 1);
  FirstContactSearch search(limbs.a.step(), limbs.b.step());
  const MovingStats found = search.advance(kUnlimited);
  for (Pose* pose : {&limbs.a.from, &limbs.a.to, &limbs.b.from, &limbs.b.to}) pose->reserve();
  Scratch scratch;
  std::optional<MovingContact> first;
  const MovingStats expected = first_contact(limbs.a.step(), limbs.b.step(), scratch, first);
  EXPECT_LE(found.posed_vertices, expected.posed_vertices);
  EXPECT_LE(found.triangle_pairs, expected.triangle_pairs);
}

TEST(FirstContactSearch, ABudgetIsExceededByLessThanTheLongestStep) {
  PassingLimbs limbs(-1, 1);
  FirstContactSearch search(limbs.a.step(), limbs.b.step());
  const std::uint64_t start = search.work_done();
  std::uint64_t granted = 0;
  while (!search.is_complete()) {
    granted += 10;
    search.advance(10);
    ASSERT_LT(search.work_done() - start, granted + search.longest_step());
  }
  EXPECT_LT(search.longest_step(), 30'000u);
}

TEST(FirstContactSearch, OpensOnePoseOfAMotionThatStandsStill) {
  PassingLimbs limbs(-1, 1);
  Pose copy(limbs.a.from.model());
  ASSERT_TRUE(copy.set_palette(PassingLimbs::at(5, 0)));
  FirstContactSearch twice({limbs.a.from, copy}, limbs.b.step());
  FirstContactSearch once({limbs.a.from, limbs.a.from}, limbs.b.step());
  twice.advance(kUnlimited);
  once.advance(kUnlimited);
  EXPECT_EQ(once.earliest(), twice.earliest());
  EXPECT_LT(once.work_done(), twice.work_done());
}

TEST(FirstContactSearch, OpensOnlyTheFirstPosesOnceBodiesTouchAtTheStart) {
  PassingLimbs limbs(0.05f, 0.1f);
  FirstContactSearch search(limbs.a.step(), limbs.b.step());
  const MovingStats stats = search.advance(kUnlimited);
  ASSERT_TRUE(search.earliest()->at_start);
  EXPECT_EQ(search.apart_until(), 0);
  limbs.a.from.reserve();  // closes all nodes
  limbs.b.from.reserve();
  Scratch scratch;
  std::vector<Contact> contacts;
  const QueryStats at_start = collide(limbs.a.from, limbs.b.from, scratch, contacts);
  EXPECT_GT(contacts.size(), 20u);
  EXPECT_LT(2 * stats.posed_vertices, 3 * at_start.posed_vertices);
}

TEST(FirstContactSearch, BecomesStaleWithANewPaletteOfAnyPose) {
  PassingLimbs limbs(-1, 1);
  for (Pose* pose : {&limbs.a.from, &limbs.a.to, &limbs.b.from, &limbs.b.to}) {
    FirstContactSearch search(limbs.a.step(), limbs.b.step());
    search.advance(500);
    EXPECT_FALSE(search.is_stale());
    const bool is_a = pose == &limbs.a.from || pose == &limbs.a.to;
    ASSERT_TRUE(pose->set_palette(PassingLimbs::at(is_a ? 5 : 4, 0.2f)));
    EXPECT_TRUE(search.is_stale());
#ifdef NDEBUG
    const std::uint64_t before = search.work_done();
    search.advance(kUnlimited);
    EXPECT_EQ(search.work_done(), before);
#endif
    search.restart();
    EXPECT_FALSE(search.is_stale());
    while (!search.is_complete()) search.advance(500);
    EXPECT_EQ(search.earliest(), first_of(limbs.a, limbs.b, false));
  }
}

TEST(FirstContactSearch, ARestartForgetsTheFormerSearch) {
  PassingLimbs limbs(0.05f, 1);
  FirstContactSearch search(limbs.a.step(), limbs.b.step());
  for (const auto& [from, to] : {std::pair(0.05f, 1.0f), std::pair(-0.6f, 1.0f),
                                 std::pair(-1.0f, 0.5f), std::pair(2.0f, 3.0f)}) {
    limbs.b.move(PassingLimbs::at(4, from), PassingLimbs::at(4, to));
    search.restart();
    search.advance(kUnlimited);
    EXPECT_EQ(search.earliest(), first_of(limbs.a, limbs.b, false));
    FirstContactSearch anew(limbs.a.step(), limbs.b.step());
    anew.advance(kUnlimited);
    EXPECT_EQ(search.work_done(), anew.work_done());
  }
  EXPECT_EQ(search.verdict(), Verdict::apart);
}

TEST(FirstContactSearch, MovesWithItsPoses) {
  PassingLimbs limbs(-1, 1);
  const auto first = first_of(limbs.a, limbs.b, false);
  FirstContactSearch search(limbs.a.step(), limbs.b.step());
  search.advance(100);
  const Pose moved_pose = std::move(limbs.a.from);
  FirstContactSearch moved = std::move(search);
  EXPECT_FALSE(moved.is_stale());
  moved.advance(kUnlimited);
  EXPECT_EQ(moved.earliest(), first);
}

using FirstContactSearchDeathTest = testing::Test;

TEST(FirstContactSearchDeathTest, ASharedPoseAborts) {
  PassingLimbs limbs(-1, 1);
  EXPECT_DEATH(FirstContactSearch(limbs.a.step(), {limbs.a.to, limbs.a.to}),
               "have a pose in common");
}

// The state of a search for the first contact depends on the work done, and not on slices,
// instruction sets, compilers or other queries.

constexpr std::uint32_t kMaxOpen = FirstContactSearch::kMaxOpen;

std::uint64_t hash_of(const FirstContactSearch& search) {
  detail::Fnv1a64 hash;
  hash.add_u32(detail::bits_as<std::uint32_t>(search.apart_until() + 0.0f));
  hash.add_u32(static_cast<std::uint32_t>(search.verdict()));
  hash.add_u32(static_cast<std::uint32_t>(search.detail().state.open.size()));
  if (const std::optional<MovingContact> first = search.earliest()) {
    for (const std::uint32_t value :
         {first->contact.triangle_a, first->contact.triangle_b,
          detail::bits_as<std::uint32_t>(first->time), static_cast<std::uint32_t>(first->at_start)})
      hash.add_u32(value);
    for (const Feature& f : {first->a, first->b})
      hash.add_u32(static_cast<std::uint32_t>(f.kind) << 8 | f.number);
  }
  return hash.value();
}

/// The hash after each call, by the work done.
using TimeStates = std::map<std::uint64_t, std::uint64_t>;

TimeStates states_of(Body& a, Body& b, std::uint64_t slice, bool leave_out_start = false,
                     std::uint32_t max_open = kMaxOpen) {
  FirstContactSearch search(a.step(), b.step(), {leave_out_start}, max_open);
  TimeStates states;
  while (!search.is_complete()) {
    search.advance(slice);
    states[search.work_done()] = hash_of(search);
  }
  return states;
}

TEST(FirstContactState, DoesNotDependOnTheSlices) {
  Random random(660);
  std::size_t compared = 0, at_start = 0;
  for_moving_bodies(random, 6, 30, [&](Body& a, Body& b) {
    for (const bool leave_out_start : {false, true})
      for (const std::uint32_t max_open : {kMaxOpen, 4u}) {
        const TimeStates steps = states_of(a, b, 1, leave_out_start, max_open);
        for (const std::uint64_t slice : {7u, 100u, 3000u, 1u << 30})
          for (const auto& [work, hash] : states_of(a, b, slice, leave_out_start, max_open)) {
            ASSERT_TRUE(steps.contains(work));
            ASSERT_EQ(steps.at(work), hash);
            ++compared;
          }
      }
    const auto first = first_of(a, b, false);
    at_start += first && first->at_start;
  });
  EXPECT_GT(compared, 500u);
  EXPECT_GT(at_start, 3u);
}

TEST(FirstContactState, AdvancingSeveralTimesEqualsAdvancingOnceByTheSum) {
  CrossingSheets sheets;
  FirstContactSearch ones(sheets.a.step(), sheets.b.step());
  constexpr std::uint64_t kRung = 2000;
  int rungs = 0;
  for (; !ones.is_complete(); ++rungs) {
    FirstContactSearch once(sheets.a.step(), sheets.b.step());
    once.advance(kRung * (rungs + 1));
    for (std::uint64_t i = 0; i < kRung; ++i) ones.advance(1);
    ASSERT_EQ(ones.work_done(), once.work_done());
    ASSERT_EQ(hash_of(ones), hash_of(once));
  }
  EXPECT_GT(rungs, 10);
}

TEST(FirstContactState, IsTheSameOnEveryInstructionSetAndCompiler) {
  on_each_instruction_set([](InstructionSet) {
    CrossingSheets sheets;
    detail::Fnv1a64 hash;
    const TimeStates states = states_of(sheets.a, sheets.b, 500);
    EXPECT_GT(states.size(), 10u);
    for (const auto& [work, state] : states) {
      hash.add_u32(static_cast<std::uint32_t>(work));
      hash.add_u32(static_cast<std::uint32_t>(state));
      hash.add_u32(static_cast<std::uint32_t>(state >> 32));
    }
    EXPECT_EQ(hash.value(), 10608621550840883216u);
  });
}

TEST(FirstContactState, DoesNotDependOnOtherQueries) {
  Random random(662);
  for_moving_bodies(random, 6, 60, [&](Body& a, Body& b) {
    Scratch scratch;
    std::vector<MovingContact> contacts;
    collide(a.step(), b.step(), scratch, contacts);
    const TimeStates warm = states_of(a, b, 50);
    for (Pose* pose : {&a.from, &a.to, &b.from, &b.to}) pose->reserve();  // closes all nodes
    ASSERT_EQ(states_of(a, b, 50), warm);
  });
}

// With reserved poses and search, nothing allocates, and few items are open.

TEST(FirstContactMemory, AllocatesNothingAfterReserve) {
  Random random(670);
  std::size_t steps = 0, unreserved = 0;
  for_moving_bodies(random, 6, 60, [&](Body& a, Body& b) {
    for (Pose* pose : {&a.from, &a.to, &b.from, &b.to}) pose->reserve();
    for (const std::uint32_t max_open : {FirstContactSearch::kMaxOpen, 0u}) {
      FirstContactSearch search(a.step(), b.step(), {}, max_open);
      search.reserve();
      FirstContactSearch other(a.step(), b.step(), {}, max_open);
      std::size_t before = allocation_count();
      for (; !search.is_complete(); ++steps) search.advance(100);
      search.restart();
      while (!search.is_complete()) search.advance(1'000'000);
      EXPECT_EQ(allocation_count(), before);
      before = allocation_count();
      while (!other.is_complete()) other.advance(100);
      unreserved += allocation_count() - before;
    }
  });
  EXPECT_GT(steps, 500u);
  EXPECT_GT(unreserved, 0u) << "the counter must count";
}

TEST(FirstContactMemory, ALimitBoundsTheOpenItems) {
  CrossingSheets sheets(40);
  const auto most_open = [&](std::uint32_t max_open) {
    FirstContactSearch search(sheets.a.step(), sheets.b.step(), {}, max_open);
    std::size_t most = 0;
    while (!search.is_complete()) {
      search.advance(50);
      most = std::max(most, search.detail().state.open.size());
    }
    return most;
  };
  const std::size_t free = most_open(1 << 20), limited = most_open(10);
  EXPECT_GT(free, 300u);
  EXPECT_LT(limited, 200u);
}

}  // namespace
}  // namespace pelt::test

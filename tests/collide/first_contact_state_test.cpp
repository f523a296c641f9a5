/// The state of a search for the first contact depends on the work done, and not on slices,
/// instruction sets, compilers or other queries.

#include <pelt/search.hpp>

#include "base/bits.hpp"
#include "base/hash.hpp"
#include "collide/first_contact_search.hpp"
#include "collide/moving_search_bodies.hpp"
#include "support/instruction_sets.hpp"

#include <gtest/gtest.h>

#include <map>

namespace pelt::test {
namespace {

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

}  // namespace
}  // namespace pelt::test

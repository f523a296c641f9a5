/// The state of a search depends on the work done, and not on slices, instruction sets, compilers
/// or other queries.

#include <pelt/collide.hpp>
#include <pelt/search.hpp>

#include "base/hash.hpp"
#include "collide/search_bodies.hpp"
#include "support/instruction_sets.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <map>

namespace pelt {
namespace {

using test::kAllOrders;
using test::Random;
using test::SearchBodies;

/// Hash of the contacts and the open regions.
std::uint64_t hash_of(const CollisionSearch& search) {
  detail::Fnv1a64 hash;
  std::vector<Contact> contacts(search.contacts().begin(), search.contacts().end());
  std::sort(contacts.begin(), contacts.end());
  for (const Contact& contact : contacts) {
    hash.add_u32(contact.triangle_a);
    hash.add_u32(contact.triangle_b);
  }
  std::vector<OpenRegion> regions;
  search.open_regions(regions);
  for (const OpenRegion& open : regions) {
    const Box& box = open.region;
    for (const float value : {box.low.x, box.low.y, box.low.z, box.high.x, box.high.y, box.high.z,
                              open.depth, static_cast<float>(open.pairs)})
      hash.add_u32(std::bit_cast<std::uint32_t>(value + 0.0f));
  }
  return hash.value();
}

/// The hash after each call, by the work done.
using States = std::map<std::uint64_t, std::uint64_t>;

States states_of(SearchBodies& bodies, SearchOrder order, std::uint64_t slice,
                 std::uint32_t max_open = CollisionSearch::kMaxOpen) {
  CollisionSearch search(bodies.a, bodies.b, order, max_open);
  States states;
  while (!search.is_complete()) {
    search.advance(slice, bodies.scratch);
    states[search.work_done()] = hash_of(search);
  }
  return states;
}

/// Sheets whose posed vertices are the same on every machine.
SearchBodies crossing_sheets() {
  constexpr std::uint32_t kCells = 20;
  SearchBodies sheets(test::make_sheet(kCells), test::make_sheet(kCells));
  sheets.set(
      test::pin(test::sheet_positions(
          kCells, [](std::uint32_t x, std::uint32_t y) { return 0.25f * float(x * y % 7); })),
      test::pin(test::sheet_positions(
          kCells, [](std::uint32_t x, std::uint32_t y) { return 0.125f * float(x + y % 5); })));
  return sheets;
}

TEST(SearchState, DoesNotDependOnTheSlices) {
  Random random(610);
  std::size_t compared = 0;
  test::for_search_bodies(random, 1, 40, [&](SearchBodies& bodies) {
    for (const SearchOrder order : kAllOrders)
      for (const std::uint32_t max_open : {CollisionSearch::kMaxOpen, 4u}) {
        const States steps = states_of(bodies, order, 1, max_open);
        for (const std::uint64_t slice : {7u, 100u, 1000u, 1u << 30})
          for (const auto& [work, hash] : states_of(bodies, order, slice, max_open)) {
            ASSERT_TRUE(steps.contains(work));
            ASSERT_EQ(steps.at(work), hash);
            ++compared;
          }
      }
  });
  EXPECT_GT(compared, 500u);
}

TEST(SearchState, AdvancingSeveralTimesEqualsAdvancingOnceByTheSum) {
  SearchBodies sheets = crossing_sheets();
  for (const SearchOrder order : {SearchOrder::resolution, SearchOrder::contacts}) {
    CollisionSearch ones(sheets.a, sheets.b, order);
    for (std::uint64_t done = 0; !ones.is_complete(); done += 300) {
      CollisionSearch once(sheets.a, sheets.b, order);
      once.advance(done + 300, sheets.scratch);
      for (int i = 0; i < 300; ++i) ones.advance(1, sheets.scratch);
      ASSERT_EQ(ones.work_done(), once.work_done());
      ASSERT_EQ(hash_of(ones), hash_of(once));
    }
  }
}

TEST(SearchState, IsTheSameOnEveryInstructionSetAndCompiler) {
  test::on_each_instruction_set([](InstructionSet) {
    SearchBodies sheets = crossing_sheets();
    detail::Fnv1a64 hash;
    for (const SearchOrder order : kAllOrders) {
      const States states = states_of(sheets, order, 500);
      EXPECT_GT(states.size(), 10u);
      for (const auto& [work, state] : states) {
        hash.add_u32(static_cast<std::uint32_t>(work));
        hash.add_u32(static_cast<std::uint32_t>(state));
        hash.add_u32(static_cast<std::uint32_t>(state >> 32));
      }
    }
    EXPECT_EQ(hash.value(), 9306803397979361932u);
  });
}

TEST(SearchState, DoesNotDependOnOtherQueries) {
  Random random(612);
  test::for_search_bodies(random, 2, 80, [&](SearchBodies& bodies) {
    for (const SearchOrder order : kAllOrders) {
      std::vector<Contact> contacts;
      collide(bodies.a, bodies.b, bodies.scratch, contacts);
      const States warm = states_of(bodies, order, 50);
      bodies.a.reserve();  // closes all nodes
      bodies.b.reserve();
      ASSERT_EQ(states_of(bodies, order, 50), warm);
    }
  });
}

}  // namespace
}  // namespace pelt

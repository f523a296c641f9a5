#include <pelt/collide.hpp>
#include <pelt/search.hpp>

#include "base/hash.hpp"
#include "collide/search_bodies.hpp"
#include "support/allocation_count.hpp"
#include "support/brute_force.hpp"
#include "support/instruction_sets.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <map>

namespace pelt {
namespace {

using test::Random;
using test::SearchBodies;

constexpr std::uint64_t kUnlimited = UINT64_MAX;

/// Limbs that touch at a distance of 0.05, and are apart at 5.
SearchBodies limbs(double distance) {
  Random random(630);
  SearchBodies bodies(test::make_limb(24, 10, 5), test::make_limb(17, 9, 4));
  const auto offset = static_cast<float>(distance);
  bodies.set(test::bend_limb(random, 5, 0.3, {}), test::bend_limb(random, 4, 0.3, {offset, 0, 0}));
  return bodies;
}

TEST(CollisionSearch, StartsUnknownAndEndsTouching) {
  SearchBodies bodies = limbs(0.05);
  CollisionSearch search(bodies.a, bodies.b, SearchOrder::contacts);
  EXPECT_EQ(search.verdict(), Verdict::unknown);
  EXPECT_EQ(search.undecided_pairs(),
            std::uint64_t{bodies.a.model().triangle_count()} * bodies.b.model().triangle_count());
  EXPECT_GT(search.resolution(), 0);
  const QueryStats stats = search.advance(kUnlimited, bodies.scratch);
  EXPECT_FALSE(stats.cut_short);
  EXPECT_TRUE(search.is_complete());
  EXPECT_EQ(search.verdict(), Verdict::touching);
  EXPECT_TRUE(std::is_sorted(search.contacts().begin(), search.contacts().end()));
}

TEST(CollisionSearch, DistantBodiesAreApartAtOnce) {
  SearchBodies bodies = limbs(5);
  const CollisionSearch search(bodies.a, bodies.b);
  EXPECT_TRUE(search.is_complete());
  EXPECT_EQ(search.verdict(), Verdict::apart);
  EXPECT_GT(search.distance_bound(), 4.5);
}

TEST(CollisionSearch, StopsAtTheFirstContactInThatOrderOnly) {
  SearchBodies bodies = limbs(0.05);
  const std::size_t all = test::contacts_of(bodies.a, bodies.b, bodies.scratch).size();
  CollisionSearch search(bodies.a, bodies.b, SearchOrder::first_contact);
  const QueryStats first = search.advance(kUnlimited, bodies.scratch);
  EXPECT_TRUE(first.cut_short);
  EXPECT_EQ(search.verdict(), Verdict::touching);
  EXPECT_GT(search.contacts().size(), 0u);
  EXPECT_LT(search.contacts().size(), all);
  search.advance(1, bodies.scratch);
  EXPECT_FALSE(search.is_complete());
  search.advance(kUnlimited, bodies.scratch);
  EXPECT_TRUE(search.is_complete());
  EXPECT_EQ(search.contacts().size(), all);
}

TEST(CollisionSearch, FirstContactTakesAboutTheWorkOfIntersects) {
  SearchBodies bodies = limbs(0.05);
  CollisionSearch search(bodies.a, bodies.b, SearchOrder::first_contact);
  const QueryStats first = search.advance(kUnlimited, bodies.scratch);
  bodies.a.reserve();
  bodies.b.reserve();
  const QueryStats expected = intersects(bodies.a, bodies.b, bodies.scratch);
  EXPECT_LE(first.posed_vertices, expected.posed_vertices);
  EXPECT_LE(work_of(first), work_of(expected) * 11 / 10);
}

TEST(CollisionSearch, ExceedsItsWorkByLessThanTheLongestStep) {
  SearchBodies bodies = limbs(0.05);
  CollisionSearch search(bodies.a, bodies.b, SearchOrder::contacts);
  const std::uint64_t start = search.work_done();
  std::uint64_t granted = 0;
  while (!search.is_complete()) {
    granted += 10;
    search.advance(10, bodies.scratch);
    ASSERT_LT(search.work_done() - start, granted + search.longest_step());
  }
  EXPECT_LT(search.longest_step(), 1000u);
}

TEST(CollisionSearch, BecomesStaleWithANewPaletteAndCanBeRestarted) {
  SearchBodies bodies = limbs(0.05);
  CollisionSearch search(bodies.a, bodies.b, SearchOrder::resolution);
  search.advance(500, bodies.scratch);
  EXPECT_FALSE(search.is_stale());
  Random random(631);
  ASSERT_TRUE(bodies.b.set_palette(test::bend_limb(random, 4, 0.3, {0.1f, 0, 0})));
  EXPECT_TRUE(search.is_stale());
#ifdef NDEBUG
  const std::uint64_t before = search.work_done();
  search.advance(kUnlimited, bodies.scratch);
  EXPECT_EQ(search.work_done(), before);
#endif
  search.restart();
  EXPECT_FALSE(search.is_stale());
  while (!search.is_complete()) search.advance(500, bodies.scratch);
  const auto expected = test::contacts_of(bodies.a, bodies.b, bodies.scratch);
  EXPECT_TRUE(std::equal(search.contacts().begin(), search.contacts().end(), expected.begin(),
                         expected.end()));
}

TEST(CollisionSearch, BecomesStaleWithNewMorphWeights) {
  SearchBodies bodies(test::make_morphing_limb(20, 10, 4), test::make_limb(17, 9, 4));
  const CollisionSearch search(bodies.a, bodies.b);
  const std::vector<float> weights(bodies.a.model().morph_target_count(), 0.5f);
  ASSERT_TRUE(bodies.a.set_morph_weights(weights));
  EXPECT_TRUE(search.is_stale());
}

TEST(CollisionSearch, CountsDisplacementsByMorphTargets) {
  SearchBodies bodies(test::make_morphing_limb(20, 10, 4), test::make_limb(17, 9, 4));
  const auto work = [&] {
    CollisionSearch search(bodies.a, bodies.b, SearchOrder::contacts);
    search.advance(kUnlimited, bodies.scratch);
    return search.work_done();
  };
  const std::uint64_t at_rest = work();
  const std::vector<float> weights(bodies.a.model().morph_target_count(), 1e-6f);
  ASSERT_TRUE(bodies.a.set_morph_weights(weights));
  EXPECT_GT(work(), at_rest + 100);
}

TEST(CollisionSearch, MovesWithItsPoses) {
  SearchBodies bodies = limbs(0.05);
  CollisionSearch search(bodies.a, bodies.b, SearchOrder::contacts);
  search.advance(100, bodies.scratch);
  const Pose moved_a = std::move(bodies.a);
  CollisionSearch moved = std::move(search);
  EXPECT_FALSE(moved.is_stale());
  moved.advance(kUnlimited, bodies.scratch);
  EXPECT_TRUE(moved.is_complete());
}

using CollisionSearchDeathTest = testing::Test;

TEST(CollisionSearchDeathTest, OnePoseTwiceAborts) {
  SearchBodies bodies = limbs(0.05);
  EXPECT_DEATH(CollisionSearch(bodies.a, bodies.a), "CollisionSearch: `a` and `b`");
}

// The state of a search depends on the work done, and not on slices, instruction sets, compilers
// or other queries.

using test::kAllOrders;

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

// With reserved poses, scratch and search, nothing allocates, and few items are open.

constexpr std::size_t kMostContacts = 20'000;

TEST(SearchMemory, AllocatesNothingAfterReserve) {
  Random random(620);
  std::size_t steps = 0, unreserved = 0;
  test::for_search_bodies(random, 4, 130, [&](SearchBodies& bodies) {
    bodies.a.reserve();
    bodies.b.reserve();
    bodies.scratch.reserve(kMostContacts);
    for (const SearchOrder order : kAllOrders)
      for (const std::uint32_t max_open : {CollisionSearch::kMaxOpen, 0u}) {
        CollisionSearch search(bodies.a, bodies.b, order, max_open);
        search.reserve(kMostContacts);
        CollisionSearch other(bodies.a, bodies.b, order, max_open);
        std::size_t before = test::allocation_count();
        for (; !search.is_complete(); ++steps) search.advance(100, bodies.scratch);
        search.restart();
        while (!search.is_complete()) search.advance(1'000'000, bodies.scratch);
        EXPECT_EQ(test::allocation_count(), before);
        before = test::allocation_count();
        while (!other.is_complete()) other.advance(100, bodies.scratch);
        unreserved += test::allocation_count() - before;
      }
  });
  EXPECT_GT(steps, 1000u);
  EXPECT_GT(unreserved, 0u) << "the counter must count";
}

TEST(SearchMemory, ALimitBoundsTheOpenRegions) {
  Random random(621);
  SearchBodies soups(test::make_soup(random, 1500, 6, 4, test::Weights::random),
                     test::make_soup(random, 1500, 5, 4, test::Weights::random));
  soups.set(test::make_palette(random, 6, test::Motion::rigid, 1),
            test::make_palette(random, 5, test::Motion::rigid, 1));
  const auto most_open = [&](std::uint32_t max_open) {
    CollisionSearch search(soups.a, soups.b, SearchOrder::resolution, max_open);
    std::vector<OpenRegion> regions;
    std::size_t most = 0;
    while (!search.is_complete()) {
      search.advance(50, soups.scratch);
      regions.clear();
      search.open_regions(regions);
      most = std::max(most, regions.size());
    }
    return most;
  };
  const std::size_t free = most_open(1 << 20), limited = most_open(10);
  EXPECT_GT(free, 150u);
  EXPECT_LT(limited, 60u);
}

}  // namespace
}  // namespace pelt

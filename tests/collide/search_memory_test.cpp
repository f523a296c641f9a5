/// With reserved poses, scratch and search, nothing allocates, and few items are open.

#include <pelt/search.hpp>

#include "collide/search_bodies.hpp"
#include "support/allocation_count.hpp"

#include <gtest/gtest.h>

namespace pelt {
namespace {

using test::kAllOrders;
using test::Random;
using test::SearchBodies;

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

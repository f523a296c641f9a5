/// With reserved poses and search, nothing allocates, and few items are open.

#include <pelt/search.hpp>

#include "collide/first_contact_search.hpp"
#include "collide/moving_search_bodies.hpp"
#include "support/allocation_count.hpp"

#include <gtest/gtest.h>

namespace pelt::test {
namespace {

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

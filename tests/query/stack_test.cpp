#include "query/scratch.hpp"

#include "support/allocation_count.hpp"
#include "support/random.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace pelt::detail {
namespace {

TEST(Stack, HoldsWhatAVectorHolds) {
  test::Random random(60);
  Stack<Contact> stack;
  std::vector<Contact> expected;
  for (int step = 0; step < 20'000; ++step) {
    if (!expected.empty() && random.chance(0.4)) {
      EXPECT_EQ(stack.pop(), expected.back());
      expected.pop_back();
    } else {
      expected.push_back({random.index(1000), random.index(1000)});
      stack.push(expected.back());
    }
    if (random.chance(0.0005)) {
      const std::size_t size = random.index(2000);
      stack.shrink(size);
      if (size < expected.size()) expected.resize(size);
    }
    ASSERT_EQ(stack.size(), expected.size());
    ASSERT_EQ(stack.empty(), expected.empty());
  }
  EXPECT_EQ(std::vector<Contact>(stack.begin(), stack.end()), expected);
  stack.clear();
  EXPECT_TRUE(stack.empty());
}

TEST(Stack, AllocatesNothingBelowWhatItOnceHeldOrReserved) {
  Stack<SlotPair> grown, reserved;
  for (std::uint32_t i = 0; i < 5000; ++i) grown.push({i, 0, 0, 0});
  reserved.reserve(5000);
  reserved.push({1, 2, 3, 4});
  grown.clear();
  const std::size_t before = test::allocation_count();
  for (std::uint32_t i = 0; i < 4999; ++i) {
    grown.push({i, 0, 0, 0});
    reserved.push({i, 0, 0, 0});
  }
  EXPECT_EQ(test::allocation_count(), before);
  reserved.reserve(10'000);
  EXPECT_GT(test::allocation_count(), before);
  EXPECT_EQ(reserved.begin()->node_b, 3u) << "growing keeps the content";
}

}  // namespace
}  // namespace pelt::detail

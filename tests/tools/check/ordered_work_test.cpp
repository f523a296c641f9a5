#include "tools/pelt/check/ordered_work.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <string>

namespace pelt::test {
namespace {

using tools::check::OrderedWork;

/// Computes squares, with an error for the items 70 and 50.
Result<void> square(std::size_t index, std::size_t& item) {
  if (index == 50 || index == 70)
    return Error{ErrorCode::invalid_argument, "item " + std::to_string(index)};
  item = index * index;
  return {};
}

TEST(OrderedWork, UsesItemsInOrder) {
  for (const std::uint32_t threads : {1u, 2u, 3u, 7u}) {
    std::vector<std::size_t> used;
    std::atomic<std::size_t> ahead = 0, most_ahead = 0;
    const auto compute = [&](std::uint32_t, std::size_t index, std::size_t& item) {
      most_ahead = std::max(most_ahead.load(), ++ahead);
      return square(index, item);
    };
    const auto use = [&](std::size_t& item) -> Result<void> {
      used.push_back(item);
      --ahead;
      return {};
    };
    EXPECT_TRUE(OrderedWork<std::size_t>(50, threads, compute, use).run());
    ASSERT_EQ(used.size(), 50u);
    for (std::size_t i = 0; i < used.size(); ++i) EXPECT_EQ(used[i], i * i);
    EXPECT_LE(most_ahead, 4 * threads);
  }
}

TEST(OrderedWork, ReturnsTheFirstErrorInOrder) {
  for (const std::uint32_t threads : {1u, 2u, 7u}) {
    std::size_t used = 0;
    const auto compute = [](std::uint32_t, std::size_t index, std::size_t& item) {
      return square(index, item);
    };
    const auto use = [&](std::size_t&) -> Result<void> {
      ++used;
      return {};
    };
    const Result<void> run = OrderedWork<std::size_t>(100, threads, compute, use).run();
    ASSERT_FALSE(run);
    EXPECT_EQ(run.error().message, "item 50");
    EXPECT_EQ(used, 50u);
  }
}

TEST(OrderedWork, ReturnsAnErrorOfTheUser) {
  const auto compute = [](std::uint32_t, std::size_t index, std::size_t& item) {
    return square(index, item);
  };
  const auto use = [](std::size_t& item) -> Result<void> {
    if (item < 100) return {};
    return Error{ErrorCode::unreadable_file, "full"};
  };
  const Result<void> run = OrderedWork<std::size_t>(100, 3, compute, use).run();
  ASSERT_FALSE(run);
  EXPECT_EQ(run.error().message, "full");
}

TEST(OrderedWork, PassesExceptionsOn) {
  const auto compute = [](std::uint32_t, std::size_t index, std::size_t&) -> Result<void> {
    if (index == 20) throw std::runtime_error("lost");
    return {};
  };
  const auto use = [](std::size_t&) -> Result<void> { return {}; };
  EXPECT_THROW((void)OrderedWork<std::size_t>(100, 3, compute, use).run(), std::runtime_error);
}

TEST(OrderedWork, PreparesItemsInOrder) {
  for (const std::uint32_t threads : {1u, 2u, 7u}) {
    std::size_t next = 0, used = 0;
    const auto prepare = [&](std::size_t& item) { item = next++; };
    const auto compute = [](std::uint32_t, std::size_t index, std::size_t& item) -> Result<void> {
      if (item == index) return {};
      return Error{ErrorCode::invalid_argument, "item " + std::to_string(item)};
    };
    const auto use = [&](std::size_t& item) -> Result<void> {
      used += item;
      return {};
    };
    EXPECT_TRUE(OrderedWork<std::size_t>(50, threads, compute, use, prepare).run());
    EXPECT_EQ(next, 50u);
    EXPECT_EQ(used, 50u * 49 / 2);
  }
}

TEST(OrderedWork, DoesNothingWithoutItems) {
  const auto compute = [](std::uint32_t, std::size_t, std::size_t&) -> Result<void> {
    return Error{ErrorCode::invalid_argument, "none"};
  };
  const auto use = [](std::size_t&) -> Result<void> { return {}; };
  EXPECT_TRUE(OrderedWork<std::size_t>(0, 2, compute, use).run());
}

}  // namespace
}  // namespace pelt::test

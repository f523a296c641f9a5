#include "base/workers.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <memory>
#include <thread>

namespace pelt::detail {
namespace {

TEST(Workers, CallEachWorkerOnceAndTheCallerAsTheFirst) {
  Workers workers;
  for (int round = 0; round < 200; ++round)
    for (const std::uint32_t count : {1u, 5u, 2u, 8u}) {
      std::atomic<std::uint32_t> calls[8] = {};
      std::atomic<bool> caller_is_first = false;
      const std::thread::id caller = std::this_thread::get_id();
      workers.run(count, [&](std::uint32_t worker) {
        ++calls[worker];
        if (std::this_thread::get_id() == caller) caller_is_first = worker == 0;
      });
      for (std::uint32_t w = 0; w < 8; ++w) ASSERT_EQ(calls[w], w < count ? 1u : 0u);
      ASSERT_TRUE(caller_is_first);
    }
}

TEST(Workers, DoTheirJobsAtTheSameTime) {
  Workers workers;
  std::atomic<int> waiting = 0;
  workers.run(3, [&](std::uint32_t) {
    ++waiting;
    while (waiting < 3) std::this_thread::yield();
  });
  EXPECT_EQ(waiting, 3);
}

TEST(Workers, ThereIsAtLeastOne) { EXPECT_GE(Workers::available(), 1u); }

TEST(WorkShares, EachNumberIsTakenOnceByHoweverManyWorkers) {
  Workers workers;
  WorkShares shares;
  for (const std::uint32_t count : {0u, 1u, 7u, 10000u})
    for (const std::uint32_t worker_count : {1u, 2u, 3u, 8u}) {
      const auto taken = std::make_unique<std::atomic<std::uint32_t>[]>(count + 1);
      shares.deal(count, worker_count);
      workers.run(worker_count, [&](std::uint32_t worker) {
        while (const auto number = shares.take(worker)) ++taken[*number];
      });
      for (std::uint32_t i = 0; i < count; ++i) ASSERT_EQ(taken[i], 1u);
    }
}

TEST(WorkShares, AWorkerTakesItsOwnFromTheFrontAndThenOthersFromTheBack) {
  WorkShares shares;
  shares.deal(6, 2);
  for (const std::uint32_t expected : {0u, 1u, 2u, 5u, 4u, 3u}) EXPECT_EQ(shares.take(0), expected);
  EXPECT_EQ(shares.take(0), std::nullopt);
  EXPECT_EQ(shares.take(1), std::nullopt);
}

}  // namespace
}  // namespace pelt::detail

#include "base/workers.hpp"
#include "support/failing_allocation.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <string>

namespace pelt::test {
namespace {

using detail::Workers;

class WorkersThatThrow : public testing::TestWithParam<std::uint32_t> {};

/// The exception reaches the caller's thread after all workers have ended, and the caller may
/// retry.
TEST_P(WorkersThatThrow, TellTheCaller) {
  Workers workers;
  std::atomic<int> ended{0};
  const auto job = [&](std::uint32_t worker) {
    ++ended;
    if (worker == GetParam()) throw std::runtime_error("of worker " + std::to_string(worker));
  };
  for (int round = 0; round < 20; ++round) {
    ended = 0;
    try {
      workers.run(4, job);
      FAIL() << "nothing was thrown";
    } catch (const std::runtime_error& error) {
      EXPECT_EQ(error.what(), "of worker " + std::to_string(GetParam()));
    }
    EXPECT_EQ(ended, 4);
  }
  workers.run(4, [&](std::uint32_t) { ++ended; });
  EXPECT_EQ(ended, 8);
}

INSTANTIATE_TEST_SUITE_P(Each, WorkersThatThrow, testing::Values(0u, 1u, 3u));

TEST(Workers, KeepTheFirstOfManyExceptions) {
  Workers workers;
  EXPECT_THROW(workers.run(4, [](std::uint32_t) { throw std::bad_alloc(); }), std::bad_alloc);
  workers.run(4, [](std::uint32_t) {});
}

/// Fewer workers run if there is no memory for more threads.
TEST(Workers, DoWithoutThreadsThatMemoryIsMissingFor) {
  const std::size_t failures = fail_each_allocation(
      [] {
        Workers workers;
        std::atomic<int> called{0};
        const Workers::Job job = [&](std::uint32_t) { ++called; };
        workers.run(4, job);
        EXPECT_GE(called, 1);
      },
      [] {});
  EXPECT_GT(failures, 3u);
}

}  // namespace
}  // namespace pelt::test

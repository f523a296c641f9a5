/// Allocation failures in a crowd: the crowd must stay unchanged and give right answers afterwards.

#include <pelt/crowd.hpp>

#include "base/workers.hpp"
#include "support/failing_allocation.hpp"
#include "support/skinned_shapes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace pelt::test {
namespace {

/// Limbs in a row: each touches its neighbours, and some are apart. Some fold onto themselves.
class Limbs {
 public:
  Limbs() : model_(*build_model(make_limb(12, 8, 3).view())), filter_(*build_self_filter(model_)) {
    Random random(31);
    for (std::uint32_t i = 0; i < 8; ++i) {
      const float x = i < 5 ? 0.08f * static_cast<float>(i) : 5 * static_cast<float>(i);
      palettes_.push_back(bend_limb(random, 3, i % 2 == 0 ? 0.3 : 1.8, {x, 0, 0}));
    }
  }

  void move(Crowd& crowd, std::uint32_t shift) const {
    for (std::uint32_t i = 0; i < palettes_.size(); ++i)
      ASSERT_TRUE(crowd.set_palette(i, palettes_[(i + shift) % palettes_.size()]));
  }

  Crowd make_crowd() const {
    Crowd crowd;
    for (std::size_t i = 0; i < palettes_.size(); ++i) crowd.add(model_);
    move(crowd, 0);
    return crowd;
  }

  /// `with_self`: each instance also against itself.
  CrowdOptions options(std::uint32_t threads, bool with_self) const {
    CrowdOptions options;
    options.threads = threads;
    if (with_self) options.self_filter = [this](std::uint32_t) { return &filter_; };
    return options;
  }

  std::vector<CrowdContact> contacts(std::uint32_t shift, bool with_self) const {
    Crowd crowd = make_crowd();
    move(crowd, shift);
    std::vector<CrowdContact> found;
    crowd.collide(found, options(1, with_self));
    return found;
  }

  const SkinnedModel& model() const { return model_; }

 private:
  SkinnedModel model_;
  SelfFilter filter_;
  std::vector<std::vector<Matrix4>> palettes_;
};

TEST(CrowdMemory, AddsAllOrNothing) {
  const Limbs limbs;
  Crowd crowd;
  std::uint32_t number = 0;
  for (std::uint32_t round = 0; round < 20; ++round) {
    const std::size_t failures = fail_each_allocation([&] { number = crowd.add(limbs.model()); },
                                                      [&] { EXPECT_EQ(crowd.size(), round); });
    EXPECT_GT(failures, 0u);
    EXPECT_EQ(number, round);
    EXPECT_EQ(crowd.size(), round + 1);
  }
  limbs.move(crowd, 0);
}

TEST(CrowdMemory, NeedsNoneToRemove) {
  const Limbs limbs;
  Crowd crowd = limbs.make_crowd();
  const FailingAllocation failing(1, true);
  while (crowd.size() > 0) crowd.remove(crowd.size() - 1);
  EXPECT_FALSE(failing.has_failed());
}

class CrowdMemoryOfThreads : public testing::TestWithParam<std::tuple<std::uint32_t, bool, bool>> {
};

/// Fails each allocation of a first query once, alone or with all that follow. Palettes change in
/// between, so nodes that were left open would give wrong answers.
TEST_P(CrowdMemoryOfThreads, CollidesAsBeforeWhenMemoryIsBack) {
  const auto [threads, for_ever, with_self] = GetParam();
  const Limbs limbs;
  const CrowdOptions options = limbs.options(threads, with_self);
  std::vector<std::vector<CrowdContact>> expected;
  for (std::uint32_t shift = 0; shift < 3; ++shift)
    expected.push_back(limbs.contacts(shift, with_self));
  ASSERT_GT(expected[0].size(), 100u);
  const auto is_self = [](const CrowdContact& c) { return c.instance_a == c.instance_b; };
  ASSERT_EQ(std::any_of(expected[0].begin(), expected[0].end(), is_self), with_self);
  const std::ptrdiff_t before = live_allocations();
  std::size_t failures = 0;
  {
    std::optional<Crowd> crowd(limbs.make_crowd());
    std::vector<CrowdContact> found(1);
    const auto check = [&] {
      ++failures;
      EXPECT_EQ(found.size(), 1u);
      found = std::vector<CrowdContact>(1);
      const std::uint32_t shift = 1 + failures % 2;
      limbs.move(*crowd, shift);
      std::vector<CrowdContact> again;
      const CrowdStats stats = crowd->collide(again, options);
      EXPECT_TRUE(again == expected[shift]);
      EXPECT_GT(stats.posed_vertices, 0u);
      crowd.emplace(limbs.make_crowd());  // without memory of earlier queries
    };
    const auto collide = [&] {
      found.resize(1);  // failing to start a thread is not an error
      crowd->collide(found, options);
    };
    fail_each_allocation(collide, check, for_ever);
    found.erase(found.begin());
    EXPECT_TRUE(found == expected[0]);
  }
  EXPECT_GT(failures, 20u);
  EXPECT_EQ(live_allocations(), before);
}

INSTANTIATE_TEST_SUITE_P(Threads, CrowdMemoryOfThreads,
                         testing::Combine(testing::Values(1u, 2u, 4u), testing::Bool(),
                                          testing::Bool()));

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

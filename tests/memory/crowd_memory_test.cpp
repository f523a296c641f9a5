/// Allocation failures in a crowd: the crowd must stay unchanged and give right answers afterwards.

#include <pelt/crowd.hpp>

#include "support/failing_allocation.hpp"
#include "support/skinned_shapes.hpp"

#include <gtest/gtest.h>

#include <optional>
#include <vector>

namespace pelt::test {
namespace {

/// Limbs in a row: each touches its neighbours, and some are apart.
class Limbs {
 public:
  Limbs() : model_(*build_model(make_limb(12, 8, 3).view())) {
    Random random(31);
    for (std::uint32_t i = 0; i < 8; ++i) {
      const float x = i < 5 ? 0.08f * static_cast<float>(i) : 5 * static_cast<float>(i);
      palettes_.push_back(bend_limb(random, 3, 0.3, {x, 0, 0}));
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

  std::vector<CrowdContact> contacts(std::uint32_t shift) const {
    Crowd crowd = make_crowd();
    move(crowd, shift);
    std::vector<CrowdContact> found;
    crowd.collide(found, {.threads = 1});
    return found;
  }

  const SkinnedModel& model() const { return model_; }

 private:
  SkinnedModel model_;
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

class CrowdMemoryOfThreads : public testing::TestWithParam<std::tuple<std::uint32_t, bool>> {};

/// Fails each allocation of a first query once, alone or with all that follow. Palettes change in
/// between, so nodes that were left open would give wrong answers.
TEST_P(CrowdMemoryOfThreads, CollidesAsBeforeWhenMemoryIsBack) {
  const auto [threads, for_ever] = GetParam();
  const Limbs limbs;
  std::vector<std::vector<CrowdContact>> expected;
  for (std::uint32_t shift = 0; shift < 3; ++shift) expected.push_back(limbs.contacts(shift));
  ASSERT_GT(expected[0].size(), 100u);
  const std::ptrdiff_t before = live_allocations();
  std::size_t failures = 0;
  {
    std::optional<Crowd> crowd(limbs.make_crowd());
    std::vector<CrowdContact> found(1);
    const auto check = [&, threads = threads] {
      ++failures;
      EXPECT_EQ(found.size(), 1u);
      found = std::vector<CrowdContact>(1);
      const std::uint32_t shift = 1 + failures % 2;
      limbs.move(*crowd, shift);
      std::vector<CrowdContact> again;
      const CrowdStats stats = crowd->collide(again, {.threads = threads});
      EXPECT_TRUE(again == expected[shift]);
      EXPECT_GT(stats.posed_vertices, 0u);
      crowd.emplace(limbs.make_crowd());  // without memory of earlier queries
    };
    const auto collide = [&, threads = threads] {
      found.resize(1);  // failing to start a thread is not an error
      crowd->collide(found, {.threads = threads});
    };
    fail_each_allocation(collide, check, for_ever);
    found.erase(found.begin());
    EXPECT_TRUE(found == expected[0]);
  }
  EXPECT_GT(failures, 20u);
  EXPECT_EQ(live_allocations(), before);
}

INSTANTIATE_TEST_SUITE_P(Threads, CrowdMemoryOfThreads,
                         testing::Combine(testing::Values(1u, 2u, 4u), testing::Bool()));

}  // namespace
}  // namespace pelt::test

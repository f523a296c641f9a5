#include <pelt/config.hpp>

#include "crowd/broad_phase.hpp"
#include "crowd/test_crowd.hpp"
#include "support/random.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <set>
#include <string>
#include <thread>

namespace pelt {
namespace {

using namespace test;

TEST(Crowd, EqualsAllPairsOneByOneWithAnyTargetAndNumberOfThreads) {
  Random random(30);
  const InstructionSet fastest = active_instruction_set();
  std::size_t contacts = 0, touching = 0, apart = 0;
  for (int round = 0; round < 12; ++round) {
    const std::uint32_t count = 2 + random.index(25);
    TestCrowd crowd = make_mixed_crowd(random, count, 1.5);
    const auto expected = crowd.expected();
    const auto expected_pairs = pairs_of(expected);
    for (const InstructionSet set : available_instruction_sets())
      for (const std::uint32_t threads : kThreadCounts) {
        ASSERT_TRUE(set_active_instruction_set(set));
        ASSERT_EQ(crowd.contacts({.threads = threads}), expected) << "round " << round;
        std::vector<CrowdPair> pairs;
        crowd.crowd.intersecting_pairs(pairs, {.threads = threads});
        ASSERT_EQ(pairs, expected_pairs);
      }
    contacts += expected.size();
    touching += expected_pairs.size();
    apart += count * (count - 1) / 2 - expected_pairs.size();
  }
  ASSERT_TRUE(set_active_instruction_set(fastest));
  EXPECT_GT(contacts, 10000u);
  EXPECT_GT(touching, 100u);
  EXPECT_GT(apart, 300u);
}

TEST(Crowd, MasksMustAgreeOnBothSides) {
  Random random(34);
  TestCrowd crowd(mixed_shapes(random));
  for (std::uint32_t i = 0; i < 30; ++i) {
    const std::uint32_t model = random.index(3);
    const CollisionMask mask = {1u << random.index(4), random.index(16)};
    crowd.move(crowd.add(model, mask), palette_for(random, model, 0.7));
  }
  const auto all = crowd.contacts();
  EXPECT_EQ(all, crowd.expected());
  EXPECT_GT(pairs_of(all).size(), 20u);
  for (std::uint32_t i = 0; i < 30; ++i) {
    crowd.masks[i] = {};
    crowd.crowd.set_collision_mask(i, {});
  }
  EXPECT_GT(pairs_of(crowd.contacts()).size(), 2 * pairs_of(all).size());
  EXPECT_EQ(crowd.contacts(), crowd.expected());
}

TEST(Crowd, FilterIsCalledOnceForEachPairWithALessThanB) {
  Random random(35);
  TestCrowd crowd = make_mixed_crowd(random, 30, 0.7);
  std::vector<CrowdPair> asked;
  CrowdOptions options;
  options.filter = [&](std::uint32_t a, std::uint32_t b) {
    asked.push_back({a, b});
    return (a + b) % 3 != 0;
  };
  std::vector<CrowdContact> contacts;
  const CrowdStats stats = crowd.crowd.collide(contacts, options);
  std::sort(asked.begin(), asked.end());
  EXPECT_EQ(std::adjacent_find(asked.begin(), asked.end()), asked.end());
  for (const CrowdPair& pair : asked) EXPECT_LT(pair.instance_a, pair.instance_b);
  EXPECT_LT(stats.candidate_pairs, asked.size());
  EXPECT_EQ(contacts, crowd.expected(options));
  EXPECT_LT(contacts.size(), crowd.contacts().size());
  EXPECT_GT(contacts.size(), 100u);
}

TEST(Crowd, StopsEachPairAtTheLimit) {
  Random random(36);
  TestCrowd crowd = make_mixed_crowd(random, 12, 0.5);
  const auto all = crowd.contacts();
  const auto pairs = pairs_of(all);
  for (const std::uint32_t limit : {0u, 1u, 7u}) {
    std::vector<CrowdContact> some;
    const CrowdStats stats = crowd.crowd.collide(some, {.max_contacts = limit});
    EXPECT_TRUE(stats.cut_short);
    EXPECT_TRUE(std::includes(all.begin(), all.end(), some.begin(), some.end()));
    for (const CrowdPair& pair : pairs) {
      const auto count = [&](const std::vector<CrowdContact>& contacts) {
        return std::count_if(contacts.begin(), contacts.end(), [&](const CrowdContact& c) {
          return CrowdPair{c.instance_a, c.instance_b} == pair;
        });
      };
      EXPECT_EQ(count(some), std::min<std::ptrdiff_t>(limit, count(all)));
    }
    std::vector<CrowdContact> with_threads;
    crowd.crowd.collide(with_threads, {.threads = 3, .max_contacts = limit});
    EXPECT_EQ(with_threads, some);
  }
}

TEST(Crowd, InstancesCanBeRemovedAndTheirNumbersGivenAnew) {
  Random random(37);
  TestCrowd crowd = make_mixed_crowd(random, 20, 0.7);
  std::uint32_t size = 20;
  std::size_t contacts = 0;
  for (int round = 0; round < 60; ++round) {
    const std::uint32_t instance = random.index(20);
    if (crowd.present[instance]) {
      crowd.remove(instance);
      --size;
    } else {
      const std::uint32_t model = random.index(3);
      const std::uint32_t added = crowd.add(model);
      ASSERT_LT(added, 20u);
      if (random.chance(0.7)) crowd.move(added, palette_for(random, model, 0.7));
      ++size;
    }
    ASSERT_EQ(crowd.crowd.size(), size);
    const auto expected = crowd.expected();
    ASSERT_EQ(crowd.contacts(), expected) << "round " << round;
    contacts += expected.size();
  }
  EXPECT_GT(contacts, 10000u);
}

TEST(Crowd, ABadPaletteLeavesTheInstanceAsItWas) {
  Random random(38);
  TestCrowd crowd = make_mixed_crowd(random, 12, 0.5);
  const auto before = crowd.contacts();
  ASSERT_GT(before.size(), 100u);
  for (std::uint32_t i = 0; i < 12; ++i) {
    auto palette = palette_for(random, model_of(crowd, i), 0.5);
    palette.back().m[5] = std::numeric_limits<float>::quiet_NaN();
    EXPECT_FALSE(crowd.crowd.set_palette(i, palette));
    palette.pop_back();
    const Result<void> refused = crowd.crowd.set_palette(i, palette);
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().message.find("expected"), std::string::npos);
  }
  EXPECT_EQ(crowd.contacts(), before);
}

TEST(Crowd, AllInOnePlaceTouchEachOther) {
  TestCrowd crowd({make_limb(12, 8, 3)});
  for (std::uint32_t i = 0; i < 25; ++i) crowd.add(0);
  std::vector<CrowdPair> pairs;
  const CrowdStats stats = crowd.crowd.intersecting_pairs(pairs);
  EXPECT_EQ(pairs.size(), 25u * 24 / 2);
  EXPECT_EQ(stats.intersecting_pairs, pairs.size());
  EXPECT_EQ(crowd.contacts(), crowd.expected());
}

TEST(Crowd, SpreadAlongAnyAxisAndAtAnySizeIsFoundByTheSweep) {
  Random random(40);
  for (int axis = 0; axis < 3; ++axis)
    for (const double scale : {1e-3, 1.0, 1e6}) {
      TestCrowd crowd({make_limb(8, 5, 1)});
      for (std::uint32_t i = 0; i < 60; ++i) {
        float place[3] = {random.uniformf(-0.1, 0.1), random.uniformf(-0.1, 0.1),
                          random.uniformf(-0.1, 0.1)};
        place[axis] = random.uniformf(-8, 8);
        Matrix4 m;
        for (std::size_t k = 0; k < 3; ++k) {
          m.m[5 * k] = static_cast<float>(scale);
          m.m[12 + k] = static_cast<float>(scale) * place[k];
        }
        crowd.move(crowd.add(0), {m});
      }
      const auto expected = crowd.expected();
      EXPECT_GT(expected.size(), 100u);
      EXPECT_EQ(crowd.contacts(), expected);
    }
}

TEST(Crowd, PalettesOfDifferentInstancesCanBeSetAtOnce) {
  Random random(41);
  TestCrowd crowd = make_mixed_crowd(random, 40, 0.8);
  std::vector<std::vector<Matrix4>> palettes;
  for (std::uint32_t i = 0; i < 40; ++i) {
    palettes.push_back(palette_for(random, model_of(crowd, i), 0.8));
    ASSERT_TRUE(crowd.poses[i].set_palette(palettes[i]));
  }
  std::vector<std::thread> threads;
  for (std::uint32_t t = 0; t < 4; ++t)
    threads.emplace_back([&crowd, &palettes, t] {
      for (std::uint32_t i = t; i < 40; i += 4)
        EXPECT_TRUE(crowd.crowd.set_palette(i, palettes[i]));
    });
  for (std::thread& thread : threads) thread.join();
  const auto expected = crowd.expected();
  EXPECT_GT(expected.size(), 1000u);
  EXPECT_EQ(crowd.contacts({.threads = 4}), expected);
}

TEST(Crowd, CanBeMoved) {
  Random random(42);
  TestCrowd crowd = make_mixed_crowd(random, 12, 0.5);
  const auto expected = crowd.contacts({.threads = 2});
  Crowd other = std::move(crowd.crowd);
  std::vector<CrowdContact> contacts;
  other.collide(contacts, {.threads = 2});
  EXPECT_EQ(contacts, expected);
  EXPECT_EQ(other.size(), 12u);
}
}  // namespace
}  // namespace pelt

namespace pelt::detail {
namespace {

std::vector<CrowdPair> island(const Islands& islands, std::uint32_t g) {
  return {islands[g].begin(), islands[g].end()};
}

TEST(Islands, OfNoPairsAreNone) {
  Islands islands;
  EXPECT_EQ(islands.count(), 0u);
  islands.form({}, 5);
  EXPECT_EQ(islands.count(), 0u);
}

TEST(Islands, KeepTheOrderOfPairsAndOfFirstPairs) {
  Islands islands;
  const std::vector<CrowdPair> pairs = {{4, 5}, {0, 2}, {5, 7}, {1, 3}, {2, 6}, {1, 2}};
  islands.form(pairs, 9);
  ASSERT_EQ(islands.count(), 2u);
  EXPECT_EQ(island(islands, 0), (std::vector<CrowdPair>{{4, 5}, {5, 7}}));
  EXPECT_EQ(island(islands, 1), (std::vector<CrowdPair>{{0, 2}, {1, 3}, {2, 6}, {1, 2}}));
}

TEST(Islands, ShareNoInstanceAndCannotBeSplit) {
  test::Random random(50);
  Islands islands;
  std::size_t most = 0;
  for (int round = 0; round < 200; ++round) {
    const std::uint32_t instances = 2 + random.index(60);
    std::vector<CrowdPair> pairs(random.index(instances));
    for (CrowdPair& pair : pairs) {
      pair.instance_b = 1 + random.index(instances - 1);
      pair.instance_a = random.index(pair.instance_b);
    }
    islands.form(pairs, instances);
    std::vector<CrowdPair> all;
    std::set<std::uint32_t> seen;
    for (std::uint32_t g = 0; g < islands.count(); ++g) {
      std::set<std::uint32_t> reached = {islands[g][0].instance_a};
      for (std::size_t step = 0; step < islands[g].size(); ++step)
        for (const auto& [a, b] : islands[g])
          if (reached.contains(a) || reached.contains(b)) reached.insert({a, b});
      for (const auto& [a, b] : islands[g]) ASSERT_TRUE(reached.contains(a));
      for (const std::uint32_t instance : reached) ASSERT_TRUE(seen.insert(instance).second);
      all.insert(all.end(), islands[g].begin(), islands[g].end());
    }
    std::sort(all.begin(), all.end());
    std::sort(pairs.begin(), pairs.end());
    ASSERT_EQ(all, pairs);
    most = std::max<std::size_t>(most, islands.count());
  }
  EXPECT_GT(most, 5u);
}

}  // namespace
}  // namespace pelt::detail

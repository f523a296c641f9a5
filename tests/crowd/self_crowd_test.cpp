/// Instances of a crowd against themselves.

#include <pelt/config.hpp>

#include "crowd/test_crowd.hpp"
#include "support/allocation_count.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace pelt {
namespace {

using namespace test;

/// Limbs often fold onto themselves.
std::vector<Matrix4> folding_palette(Random& random, std::uint32_t model, const Vec3& place) {
  if (model == 2) return palette_for(random, model, 1);
  return bend_limb(random, model == 0 ? 3 : 5, random.uniform(0.3, 2.2), place);
}

/// Instances some of which fold onto themselves, some touch others, and some are far from all.
TestCrowd make_folding_crowd(Random& random, std::uint32_t count, double room) {
  TestCrowd crowd(mixed_shapes(random));
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t model = random.index(10) == 0 ? 2 : random.index(2);
    const std::uint32_t instance = crowd.add(model);
    Vec3 place = random.point(room);
    if (random.chance(0.3)) place.x += 100 + 5 * static_cast<float>(i);
    crowd.move(instance, folding_palette(random, model, place));
  }
  return crowd;
}

/// Asks about all instances except every fourth.
CrowdOptions ask_most(const TestCrowd& crowd, const std::vector<SelfFilter>& filters,
                      std::uint32_t threads) {
  return {.threads = threads, .self_filter = [&](std::uint32_t instance) -> const SelfFilter* {
            return instance % 4 == 3 ? nullptr : &filters[model_of(crowd, instance)];
          }};
}

std::size_t count_selves(const std::vector<CrowdPair>& pairs) {
  return static_cast<std::size_t>(std::count_if(
      pairs.begin(), pairs.end(), [](const CrowdPair& p) { return p.instance_a == p.instance_b; }));
}

TEST(SelfCrowd, EqualsPosesOneByOneWithAnyInstructionSetAndNumberOfThreads) {
  Random random(60);
  const InstructionSet fastest = active_instruction_set();
  std::size_t contacts = 0, selves = 0, others = 0;
  for (int round = 0; round < 10; ++round) {
    TestCrowd crowd = make_folding_crowd(random, 1 + random.index(30), 1.5);
    const std::vector<SelfFilter> filters = crowd.self_filters(round % 3);
    const auto expected = crowd.expected(ask_most(crowd, filters, 1));
    const auto expected_pairs = pairs_of(expected);
    for (const InstructionSet set : available_instruction_sets())
      for (const std::uint32_t threads : kThreadCounts) {
        ASSERT_TRUE(set_active_instruction_set(set));
        const CrowdOptions options = ask_most(crowd, filters, threads);
        ASSERT_EQ(crowd.contacts(options), expected) << "round " << round;
        std::vector<CrowdPair> pairs;
        const CrowdStats stats = crowd.crowd.intersecting_pairs(pairs, options);
        ASSERT_EQ(pairs, expected_pairs);
        ASSERT_EQ(stats.self_intersecting, count_selves(pairs));
        ASSERT_EQ(stats.intersecting_pairs, pairs.size() - count_selves(pairs));
      }
    contacts += expected.size();
    selves += count_selves(expected_pairs);
    others += expected_pairs.size() - count_selves(expected_pairs);
  }
  ASSERT_TRUE(set_active_instruction_set(fastest));
  EXPECT_GT(contacts, 5000u);
  EXPECT_GT(selves, 30u);
  EXPECT_GT(others, 30u);
}

TEST(CrowdCostOfSelf, StatsDoNotDependOnThreads) {
  Random random(61);
  TestCrowd crowd = make_folding_crowd(random, 40, 1.2);
  const std::vector<SelfFilter> filters = crowd.self_filters(1);
  std::vector<std::vector<Matrix4>> palettes;
  for (std::uint32_t i = 0; i < 40; ++i)
    palettes.push_back(folding_palette(random, model_of(crowd, i), random.point(1.2)));
  std::vector<CrowdContact> contacts;
  const auto ask = [&](std::uint32_t threads) {
    for (std::uint32_t i = 0; i < 40; ++i) EXPECT_TRUE(crowd.crowd.set_palette(i, palettes[i]));
    contacts.clear();
    return crowd.crowd.collide(contacts, ask_most(crowd, filters, threads));
  };
  const CrowdStats expected = ask(1);
  EXPECT_EQ(expected.self_tests, 30u);
  EXPECT_GT(expected.self_intersecting, 3u);
  EXPECT_GT(expected.candidate_pairs, 20u);
  EXPECT_GT(expected.left_out.rings, 10u);
  EXPECT_EQ(expected.left_out.rings, expected.left_out.total());
  for (int repeat = 0; repeat < 10; ++repeat)
    for (const std::uint32_t threads : kThreadCounts) {
      const CrowdStats stats = ask(threads);
      ASSERT_EQ(stats.node_pairs, expected.node_pairs) << threads << " threads";
      ASSERT_EQ(stats.refits, expected.refits);
      ASSERT_EQ(stats.posed_vertices, expected.posed_vertices);
      ASSERT_EQ(stats.triangle_pairs, expected.triangle_pairs);
      ASSERT_EQ(stats.self_tests, expected.self_tests);
      ASSERT_EQ(stats.self_intersecting, expected.self_intersecting);
      ASSERT_EQ(stats.candidate_pairs, expected.candidate_pairs);
      ASSERT_EQ(stats.left_out.rings, expected.left_out.rings);
    }
}

TEST(SelfCrowd, TestsOnlyInstancesAgainstThemselvesIfThePairsAreFiltered) {
  Random random(62);
  TestCrowd crowd = make_folding_crowd(random, 20, 0.5);
  const std::vector<SelfFilter> filters = crowd.self_filters();
  CrowdOptions options = ask_most(crowd, filters, 3);
  options.filter = [](std::uint32_t a, std::uint32_t b) {
    EXPECT_LT(a, b);
    return false;
  };
  const auto contacts = crowd.contacts(options);
  EXPECT_EQ(contacts, crowd.expected(options));
  EXPECT_GT(contacts.size(), 100u);
  for (const CrowdContact& c : contacts) {
    EXPECT_EQ(c.instance_a, c.instance_b);
    EXPECT_LT(c.triangle_a, c.triangle_b);
  }
}

TEST(SelfCrowd, IgnoresCollisionMasks) {
  Random random(63);
  TestCrowd crowd = make_folding_crowd(random, 20, 0.5);
  const std::vector<SelfFilter> filters = crowd.self_filters();
  for (std::uint32_t i = 0; i < 20; ++i) {
    crowd.masks[i] = {0, 0};
    crowd.crowd.set_collision_mask(i, {0, 0});
  }
  const auto contacts = crowd.contacts(ask_most(crowd, filters, 1));
  EXPECT_EQ(contacts, crowd.expected(ask_most(crowd, filters, 1)));
  EXPECT_GT(contacts.size(), 100u);
}

TEST(SelfCrowd, StopsEachTestAtTheLimit) {
  Random random(64);
  TestCrowd crowd = make_folding_crowd(random, 15, 0.5);
  const std::vector<SelfFilter> filters = crowd.self_filters();
  const auto all = crowd.contacts(ask_most(crowd, filters, 1));
  for (const std::uint32_t limit : {0u, 1u, 7u}) {
    CrowdOptions options = ask_most(crowd, filters, 1);
    options.max_contacts = limit;
    const auto some = crowd.contacts(options);
    EXPECT_TRUE(std::includes(all.begin(), all.end(), some.begin(), some.end()));
    for (const CrowdPair& pair : pairs_of(all)) {
      const auto count = [&](const std::vector<CrowdContact>& contacts) {
        return std::count_if(contacts.begin(), contacts.end(), [&](const CrowdContact& c) {
          return CrowdPair{c.instance_a, c.instance_b} == pair;
        });
      };
      EXPECT_EQ(count(some), std::min<std::ptrdiff_t>(limit, count(all)));
    }
    options.threads = 3;
    EXPECT_EQ(crowd.contacts(options), some);
  }
}

TEST(SelfCrowd, FollowsMovesAndRemovals) {
  Random random(65);
  TestCrowd crowd = make_folding_crowd(random, 16, 0.7);
  const std::vector<SelfFilter> filters = crowd.self_filters();
  std::size_t contacts = 0;
  for (int frame = 0; frame < 30; ++frame) {
    const std::uint32_t instance = random.index(16);
    if (frame % 5 == 4 && crowd.present[instance]) {
      crowd.remove(instance);
      ASSERT_EQ(crowd.add(0), instance);
    }
    crowd.move(instance, folding_palette(random, model_of(crowd, instance), random.point(0.7)));
    const auto expected = crowd.expected(ask_most(crowd, filters, 1));
    ASSERT_EQ(crowd.contacts(ask_most(crowd, filters, 1 + frame % 3)), expected) << frame;
    // Queries without self-tests in between.
    ASSERT_EQ(crowd.contacts(), crowd.expected()) << frame;
    contacts += expected.size();
  }
  EXPECT_GT(contacts, 5000u);
}

TEST(CrowdCostOfSelf, ARepeatedFrameAllocatesNothing) {
  for (const std::uint32_t threads : kThreadCounts) {
    Random random(66);
    TestCrowd crowd = make_folding_crowd(random, 40, 1);
    const std::vector<SelfFilter> filters = crowd.self_filters(2);
    const CrowdOptions options = ask_most(crowd, filters, threads);
    std::vector<std::vector<Matrix4>> palettes;
    for (std::uint32_t i = 0; i < 40; ++i)
      palettes.push_back(folding_palette(random, model_of(crowd, i), random.point(1)));
    std::vector<CrowdContact> contacts;
    std::vector<CrowdPair> pairs;
    contacts.reserve(1 << 18);
    pairs.reserve(1 << 12);
    std::size_t bytes = 0;
    for (int frame = 0; frame < 8; ++frame) {
      contacts.clear();
      pairs.clear();
      const std::size_t before = allocation_count();
      for (std::uint32_t i = 0; i < 40; ++i) ASSERT_TRUE(crowd.crowd.set_palette(i, palettes[i]));
      crowd.crowd.collide(contacts, options);
      crowd.crowd.intersecting_pairs(pairs, options);
      if (frame > 0) {
        ASSERT_EQ(allocation_count(), before) << "frame " << frame << ", " << threads;
        ASSERT_LE(crowd.crowd.memory_bytes(), bytes) << "replaced blocks may be freed";
      }
      bytes = crowd.crowd.memory_bytes();
    }
    EXPECT_GT(count_selves(pairs), 3u);
    EXPECT_LT(contacts.size(), 1u << 18);
  }
}

TEST(SelfCrowd, RefusesTheFilterOfAnotherModel) {
  Random random(67);
  TestCrowd crowd = make_folding_crowd(random, 4, 1);
  const SkinnedModel other = *build_model(make_limb(5, 5, 2).view());
  const SelfFilter filter = *build_self_filter(other);
  CrowdOptions options;
  options.threads = 1;
  options.self_filter = [&](std::uint32_t) { return &filter; };
  EXPECT_DEATH(crowd.contacts(options), "filter of another model");
}

}  // namespace
}  // namespace pelt

#include <pelt/config.hpp>

#include "crowd/test_crowd.hpp"
#include "support/allocation_count.hpp"

#include <gtest/gtest.h>

namespace pelt {
namespace {

using namespace test;

bool same_work(const QueryStats& a, const QueryStats& b) {
  return a.node_pairs == b.node_pairs && a.refits == b.refits &&
         a.posed_vertices == b.posed_vertices && a.triangle_pairs == b.triangle_pairs &&
         a.cut_short == b.cut_short;
}

TEST(CrowdCost, StatsDoNotDependOnThreadsOrInstructionSets) {
  Random random(31);
  const InstructionSet fastest = active_instruction_set();
  TestCrowd crowd = make_mixed_crowd(random, 40, 1.5);
  std::vector<std::vector<Matrix4>> palettes;
  for (std::uint32_t i = 0; i < 40; ++i)
    palettes.push_back(palette_for(random, model_of(crowd, i), 1.5));
  std::vector<CrowdContact> contacts;
  const auto ask_anew = [&](std::uint32_t threads) {
    for (std::uint32_t i = 0; i < 40; ++i) EXPECT_TRUE(crowd.crowd.set_palette(i, palettes[i]));
    contacts.clear();
    return crowd.crowd.collide(contacts, {.threads = threads});
  };
  const CrowdStats expected = ask_anew(1);
  const auto expected_contacts = contacts;
  EXPECT_GT(expected.intersecting_pairs, 30u);
  EXPECT_GT(expected.candidate_pairs, expected.intersecting_pairs);
  EXPECT_GT(expected.refits, 500u);
  EXPECT_GT(expected.posed_vertices, 1000u);
  EXPECT_GT(expected.triangle_pairs, 1000u);
  for (const InstructionSet set : available_instruction_sets()) {
    ASSERT_TRUE(set_active_instruction_set(set));
    for (int repeat = 0; repeat < 10; ++repeat)
      for (const std::uint32_t threads : kThreadCounts) {
        const CrowdStats stats = ask_anew(threads);
        ASSERT_TRUE(same_work(stats, expected)) << threads << " threads";
        ASSERT_EQ(stats.candidate_pairs, expected.candidate_pairs);
        ASSERT_EQ(stats.intersecting_pairs, expected.intersecting_pairs);
        ASSERT_EQ(contacts, expected_contacts);
      }
  }
  ASSERT_TRUE(set_active_instruction_set(fastest));
}

TEST(CrowdCost, OpensANodeOnceHoweverManyPairsAsk) {
  Random random(32);
  TestCrowd crowd = make_mixed_crowd(random, 30, 0.8);
  Scratch scratch;
  std::vector<Contact> contacts;
  for (const std::uint32_t threads : kThreadCounts) {
    for (std::uint32_t i = 0; i < 30; ++i)
      crowd.move(i, palette_for(random, model_of(crowd, i), 0.8));
    QueryStats one_by_one;
    for (std::uint32_t a = 0; a < 30; ++a)
      for (std::uint32_t b = a + 1; b < 30; ++b)
        one_by_one += pelt::collide(crowd.poses[a], crowd.poses[b], scratch, contacts);
    std::vector<CrowdContact> found;
    const QueryStats work = crowd.crowd.collide(found, {.threads = threads});
    EXPECT_EQ(work.refits, one_by_one.refits);
    EXPECT_EQ(work.posed_vertices, one_by_one.posed_vertices);
    EXPECT_EQ(work.triangle_pairs, one_by_one.triangle_pairs);
    EXPECT_GT(work.refits, 300u);
  }
}

TEST(CrowdCost, ForgetsWhatItOpened) {
  Random random(45);
  TestCrowd crowd = make_mixed_crowd(random, 15, 0.5);
  for (int frame = 0; frame < 30; ++frame) {
    for (std::uint32_t i = 0; i < 15; ++i)
      if (random.chance(0.3)) crowd.move(i, palette_for(random, model_of(crowd, i), 0.5));
    ASSERT_EQ(crowd.contacts(), crowd.expected()) << "frame " << frame;
  }
}

TEST(CrowdCost, OfNobodyOrOneHasNoContacts) {
  Crowd crowd;
  std::vector<CrowdContact> contacts;
  EXPECT_EQ(crowd.collide(contacts).candidate_pairs, 0u);
  const auto limb = make_limb(12, 8, 3);
  EXPECT_EQ(crowd.add(*build_model(limb.view())), 0u);
  const CrowdStats stats = crowd.collide(contacts);
  EXPECT_EQ(stats.candidate_pairs, 0u);
  EXPECT_EQ(stats.refits, 1u) << "its box";
  EXPECT_EQ(stats.posed_vertices, 0u);
  EXPECT_TRUE(contacts.empty());
  EXPECT_EQ(crowd.model(0).joint_count(), 3u);
}

TEST(CrowdCost, FarApartCostsABoxEach) {
  Random random(39);
  TestCrowd crowd(mixed_shapes(random));
  for (std::uint32_t i = 0; i < 300; ++i)
    crowd.move(crowd.add(0),
               bend_limb(random, 3, 0.2,
                         {static_cast<float>(i % 7) * 5, 0, static_cast<float>(i / 7) * 5 - 1000}));
  std::vector<CrowdContact> contacts;
  const CrowdStats stats = crowd.crowd.collide(contacts);
  EXPECT_EQ(stats.candidate_pairs, 0u);
  EXPECT_EQ(stats.refits, 300u);
  EXPECT_EQ(stats.node_pairs, 0u);
  EXPECT_TRUE(contacts.empty());
}

TEST(CrowdCost, ARepeatedFrameAllocatesNothing) {
  for (const std::uint32_t threads : kThreadCounts) {
    Random random(43);
    TestCrowd crowd = make_mixed_crowd(random, 60, 1);
    std::vector<std::vector<Matrix4>> palettes;
    for (std::uint32_t i = 0; i < 60; ++i)
      palettes.push_back(palette_for(random, model_of(crowd, i), 1));
    std::vector<CrowdContact> contacts;
    std::vector<CrowdPair> pairs;
    contacts.reserve(1 << 18);
    pairs.reserve(1 << 12);
    for (int frame = 0; frame < 8; ++frame) {
      contacts.clear();
      pairs.clear();
      const std::size_t before = allocation_count();
      for (std::uint32_t i = 0; i < 60; ++i) ASSERT_TRUE(crowd.crowd.set_palette(i, palettes[i]));
      crowd.crowd.collide(contacts, {.threads = threads});
      crowd.crowd.intersecting_pairs(pairs, {.threads = threads});
      if (frame > 0) {
        ASSERT_EQ(allocation_count(), before) << "frame " << frame << ", " << threads;
      }
    }
    EXPECT_GT(contacts.size(), 1000u);
    EXPECT_LT(contacts.size(), 1u << 18);
  }
}

TEST(CrowdCost, MemoryGrowsWithWhatIsOpenedNotWithTheModel) {
  const Shape fine = make_limb(300, 60, 5);
  const SkinnedModel model = *build_model(fine.view());
  Random random(44);
  Crowd crowd;
  for (std::uint32_t i = 0; i < 1000; ++i) {
    ASSERT_EQ(crowd.add(model), i);
    const Vec3 place = {static_cast<float>(i % 32) * 3, 0, static_cast<float>(i / 32) * 3};
    ASSERT_TRUE(crowd.set_palette(i, bend_limb(random, 5, 0.2, place)));
  }
  std::vector<CrowdContact> contacts;
  ASSERT_EQ(crowd.collide(contacts).candidate_pairs, 0u);
  EXPECT_LT(crowd.memory_bytes(), 1000u * 1000)
      << "a kilobyte an instance, of which 320 are its palette";

  const std::size_t before = crowd.memory_bytes();
  for (std::uint32_t i = 0; i < 1000; i += 100)
    ASSERT_TRUE(crowd.set_palette(i, bend_limb(random, 5, 0.2, {500, 0, 0})));
  ASSERT_GT(crowd.collide(contacts, {.threads = 1}).intersecting_pairs, 10u);
  EXPECT_GT(crowd.memory_bytes(), before);
  EXPECT_LT(crowd.memory_bytes(), before + 20u * 36000 * 50);
}

}  // namespace
}  // namespace pelt

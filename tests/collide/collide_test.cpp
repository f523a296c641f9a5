#include <pelt/collide.hpp>

#include "collide/cluster_pair.hpp"
#include "collide/collide_trees.hpp"
#include "pose/pose.hpp"
#include "query/scratch.hpp"
#include "support/limbs.hpp"

#include <gtest/gtest.h>

#include <optional>
#include <utility>
#include <vector>

namespace pelt {
namespace {

using test::LimbPair;
using test::Random;
using test::Shape;

TEST(Collide, RefitsANodeAtMostOnceForEachPaletteHoweverManyQueriesAsk) {
  Random random(15);
  LimbPair limbs;
  const SkinnedModel model = limbs.b.model();
  const auto palette_b = test::bend_limb(random, 4, 0.3, {0.05f, 0, 0});
  const auto palette_third = test::bend_limb(random, 4, 0.3, {0.02f, 0, 0});
  Pose third(model);
  limbs.move(random, 0.05);
  ASSERT_TRUE(limbs.b.set_palette(palette_b));
  ASSERT_TRUE(third.set_palette(palette_third));
  std::vector<Contact> contacts;
  const QueryStats first = collide(limbs.a, limbs.b, limbs.scratch, contacts);
  const QueryStats again = collide(limbs.a, limbs.b, limbs.scratch, contacts);
  EXPECT_GT(first.refits, 0u);
  EXPECT_GT(first.posed_vertices, 0u);
  EXPECT_EQ(again.refits, 0u);
  EXPECT_EQ(again.posed_vertices, 0u);
  EXPECT_EQ(again.node_pairs, first.node_pairs);
  EXPECT_EQ(again.triangle_pairs, first.triangle_pairs);

  collide(limbs.a, third, limbs.scratch, contacts);
  const QueryStats shared = collide(limbs.b, third, limbs.scratch, contacts);
  Pose fresh_b(model), fresh_third(model);
  ASSERT_TRUE(fresh_b.set_palette(palette_b));
  ASSERT_TRUE(fresh_third.set_palette(palette_third));
  const QueryStats fresh = collide(fresh_b, fresh_third, limbs.scratch, contacts);
  EXPECT_LT(shared.refits, fresh.refits / 2) << "shares what was refitted";
  EXPECT_LT(shared.posed_vertices, fresh.posed_vertices / 2);
  EXPECT_EQ(shared.triangle_pairs, fresh.triangle_pairs);
}

TEST(Collide, SeparatedBodiesCostTwoRefits) {
  Random random(16);
  LimbPair limbs;
  limbs.move(random, 0);
  ASSERT_TRUE(limbs.b.set_palette(test::bend_limb(random, 4, 0.1, {50, 0, 0})));
  std::vector<Contact> contacts;
  const QueryStats stats = collide(limbs.a, limbs.b, limbs.scratch, contacts);
  EXPECT_EQ(stats.node_pairs, 1u);
  EXPECT_EQ(stats.refits, 2u);
  EXPECT_EQ(stats.posed_vertices, 0u);
  EXPECT_TRUE(contacts.empty());
  EXPECT_FALSE(collide(limbs.a, limbs.b, limbs.scratch, contacts, {.max_contacts = 0}).cut_short);
}

/// Opened nodes of a mesh stay open while it does not move.
TEST(Collide, PosesAMeshOnceWhileItStands) {
  Random random(752);
  LimbPair limbs;
  Pose rock(*build_model(test::make_soup(random, 300, 1, 1, test::Weights::one_joint).view()));
  std::vector<Contact> contacts;
  const auto palette = test::bend_limb(random, 5, 0.5, {});
  ASSERT_TRUE(limbs.a.set_palette(palette));
  const QueryStats first = collide(limbs.a, rock, limbs.scratch, contacts);
  ASSERT_TRUE(limbs.a.set_palette(palette));
  const QueryStats second = collide(limbs.a, rock, limbs.scratch, contacts);
  EXPECT_GT(second.posed_vertices, 0u);
  EXPECT_LT(second.posed_vertices, first.posed_vertices);
  EXPECT_FALSE(contacts.empty());
}

TEST(Collide, PosesOfOneModelAreIndependent) {
  const Shape limb = test::make_limb(12, 8, 3);
  const SkinnedModel model = *build_model(limb.view());
  Pose a(model), b(model);
  Scratch scratch;
  std::vector<Contact> contacts;
  collide(a, b, scratch, contacts);
  EXPECT_GE(contacts.size(), limb.triangles.size()) << "a body touches its twin everywhere";
  Random random(18);
  ASSERT_TRUE(b.set_palette(test::bend_limb(random, 3, 0, {5, 0, 0})));
  EXPECT_FALSE(intersects(a, b, scratch));
}

TEST(QueryStats, AddUp) {
  QueryStats sum{.node_pairs = 1, .refits = 2, .posed_vertices = 3, .triangle_pairs = 4};
  sum += QueryStats{.node_pairs = 10,
                    .refits = 20,
                    .posed_vertices = 30,
                    .triangle_pairs = 40,
                    .cut_short = true};
  EXPECT_EQ(sum.node_pairs, 11u);
  EXPECT_EQ(sum.refits, 22u);
  EXPECT_EQ(sum.posed_vertices, 33u);
  EXPECT_EQ(sum.triangle_pairs, 44u);
  EXPECT_TRUE(sum.cut_short);
}

TEST(LowestContact, TestsFewerTrianglesThanAllContacts) {
  Random random(32);
  Pose a(*build_model(test::make_limb(40, 16, 5).view()));
  Pose b(*build_model(test::make_limb(40, 16, 4).view()));
  Scratch scratch;
  std::uint64_t all = 0, lowest = 0;
  std::optional<Contact> found;
  std::vector<Contact> contacts;
  for (int round = 0; round < 30; ++round) {
    ASSERT_TRUE(a.set_palette(test::bend_limb(random, 5, random.uniform(-0.6, 0.6), {})));
    ASSERT_TRUE(
        b.set_palette(test::bend_limb(random, 4, random.uniform(-0.6, 0.6), random.point(0.3))));
    all += collide(a, b, scratch, contacts).triangle_pairs;
    lowest +=
        lowest_contact(a.detail().posed_tree(), b.detail().posed_tree(), scratch.detail(), found)
            .triangle_pairs;
  }
  EXPECT_LT(2 * lowest, all);
}

using Pairs = std::vector<std::pair<unsigned, unsigned>>;

Pairs contents(const detail::RowLanes& list) {
  Pairs pairs;
  for (std::uint32_t i = 0; i < list.size(); ++i) pairs.emplace_back(list.row(i), list.lane(i));
  return pairs;
}

TEST(RowLanes, ListsTheLanesOfEverySetOfBits) {
  for (unsigned lanes = 0; lanes < 0x10000; ++lanes) {
    const unsigned row = lanes % 16;
    Pairs expected;
    for (unsigned lane = 0; lane < 16; ++lane)
      if (lanes >> lane & 1) expected.emplace_back(row, lane);
    detail::RowLanes list;
    list.add(row, lanes);
    ASSERT_EQ(contents(list), expected) << "lanes " << lanes;
  }
}

TEST(RowLanes, KeepsTheOrderOfRowsUpToAllPairs) {
  Pairs expected;
  detail::RowLanes list;
  for (unsigned row = 0; row < 16; ++row) {
    list.add(15 - row, 0);
    list.add(row, 0xFFFF);
    for (unsigned lane = 0; lane < 16; ++lane) expected.emplace_back(row, lane);
  }
  EXPECT_EQ(contents(list), expected);
}

}  // namespace
}  // namespace pelt

#include <pelt/collide.hpp>

#include "contacts_of.hpp"
#include "support/allocation_count.hpp"
#include "support/skinned_shapes.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace pelt {
namespace {

using test::brute_force;
using test::contacts_of;
using test::Motion;
using test::Random;
using test::Shape;
using test::Weights;

/// Two bending limbs that often touch.
struct Limbs {
  Shape shape_a = test::make_limb(24, 10, 5), shape_b = test::make_limb(17, 9, 4);
  Pose a = Pose(*build_model(shape_a.view())), b = Pose(*build_model(shape_b.view()));
  Scratch scratch;

  void move(Random& random, double distance) {
    ASSERT_TRUE(a.set_palette(test::bend_limb(random, 5, random.uniform(-0.6, 0.6), {})));
    ASSERT_TRUE(b.set_palette(
        test::bend_limb(random, 4, random.uniform(-0.6, 0.6), random.point(distance))));
  }
};

TEST(Collide, EqualsBruteForceOnBendingLimbs) {
  Random random(10);
  Limbs limbs;
  int touching = 0, apart = 0;
  for (int round = 0; round < 300; ++round) {
    limbs.move(random, 0.3);
    const auto expected = brute_force(limbs.shape_a, limbs.a, limbs.shape_b, limbs.b);
    ASSERT_EQ(contacts_of(limbs.a, limbs.b, limbs.scratch), expected) << "round " << round;
    ASSERT_EQ(intersects(limbs.a, limbs.b, limbs.scratch).answer, !expected.empty());
    ++(expected.empty() ? apart : touching);
  }
  EXPECT_GT(touching, 60);
  EXPECT_GT(apart, 60);
}

TEST(Collide, EqualsBruteForceOnSoupsUnderAnyAffineJoints) {
  Random random(11);
  Scratch scratch;
  std::size_t contacts = 0;
  int cases = 0, touching = 0;
  for (const Motion motion : {Motion::rigid, Motion::affine, Motion::collapsed, Motion::far_away})
    for (const Weights weights : {Weights::one_joint, Weights::random, Weights::adversarial})
      for (const std::uint32_t influences : {1u, 3u, 4u, 9u}) {
        const Shape a = test::make_soup(random, 150, 6, influences, weights);
        const Shape b = test::make_soup(random, 120, 5, influences, weights);
        Pose pose_a(*build_model(a.view())), pose_b(*build_model(b.view()));
        ASSERT_TRUE(pose_a.set_palette(test::make_palette(random, 6, motion, 1)));
        ASSERT_TRUE(pose_b.set_palette(test::make_palette(random, 5, motion, 1)));
        const auto expected = brute_force(a, pose_a, b, pose_b);
        ASSERT_EQ(contacts_of(pose_a, pose_b, scratch), expected);
        contacts += expected.size();
        touching += !expected.empty();
        ++cases;
      }
  EXPECT_GT(touching, cases * 3 / 4);
  EXPECT_GT(contacts, 1000u);
}

TEST(Collide, SwappingTheBodiesSwapsThePairs) {
  Random random(12);
  Limbs limbs;
  std::size_t seen = 0;
  for (int round = 0; round < 50; ++round) {
    limbs.move(random, 0.3);
    const auto forward = contacts_of(limbs.a, limbs.b, limbs.scratch);
    auto backward = contacts_of(limbs.b, limbs.a, limbs.scratch);
    for (Contact& c : backward) std::swap(c.triangle_a, c.triangle_b);
    std::sort(backward.begin(), backward.end());
    ASSERT_EQ(forward, backward);
    seen += forward.size();
  }
  EXPECT_GT(seen, 200u);
}

TEST(Collide, AppendsInAscendingOrder) {
  Random random(13);
  Limbs limbs;
  limbs.move(random, 0.05);
  std::vector<Contact> contacts = {{7, 7}};
  collide(limbs.a, limbs.b, limbs.scratch, contacts);
  ASSERT_GT(contacts.size(), 10u);
  EXPECT_EQ(contacts[0], (Contact{7, 7}));
  EXPECT_TRUE(std::is_sorted(contacts.begin() + 1, contacts.end()));
}

TEST(Collide, StopsAtTheLimit) {
  Random random(14);
  Limbs limbs;
  limbs.move(random, 0.05);
  const auto all = contacts_of(limbs.a, limbs.b, limbs.scratch);
  const auto count = static_cast<std::uint32_t>(all.size());
  ASSERT_GT(count, 10u);
  for (const std::uint32_t limit : {0u, 1u, 5u, count - 1, count, count + 1}) {
    std::vector<Contact> some;
    const QueryStats stats =
        collide(limbs.a, limbs.b, limbs.scratch, some, {.max_contacts = limit});
    EXPECT_EQ(some.size(), std::min(limit, count));
    EXPECT_TRUE(std::includes(all.begin(), all.end(), some.begin(), some.end()));
    if (limit != count) {
      EXPECT_EQ(stats.cut_short, limit < count);
    }
  }
}

TEST(Collide, RefitsANodeAtMostOnceForEachPaletteHoweverManyQueriesAsk) {
  Random random(15);
  Limbs limbs;
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
  Limbs limbs;
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

TEST(Collide, DoesNotAllocateOnceWarm) {
  Random random(17);
  Limbs limbs;
  std::vector<Contact> contacts;
  limbs.move(random, 0.05);
  collide(limbs.a, limbs.b, limbs.scratch, contacts);
  contacts.reserve(1 << 16);
  const auto palette = test::bend_limb(random, 5, 0.4, {});
  for (int round = 0; round < 3; ++round) {
    contacts.clear();
    const std::size_t before = test::allocation_count();
    ASSERT_TRUE(limbs.a.set_palette(palette));
    collide(limbs.a, limbs.b, limbs.scratch, contacts);
    intersects(limbs.a, limbs.b, limbs.scratch);
    if (round > 0) {
      EXPECT_EQ(test::allocation_count(), before);
    }
  }
  EXPECT_GT(test::allocation_count(), 0u) << "the counter must count";
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

}  // namespace
}  // namespace pelt

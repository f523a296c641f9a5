#include <pelt/collide.hpp>

#include "collide/cluster_pair.hpp"
#include "collide/collide_trees.hpp"
#include "pose/pose.hpp"
#include "query/scratch.hpp"
#include "support/allocation_count.hpp"
#include "support/brute_force.hpp"
#include "support/instruction_sets.hpp"
#include "support/skinned_shapes.hpp"

#include <gtest/gtest.h>

#include <cmath>
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

// With reserved poses and scratch, no query allocates, not even the first: for the deepest tree,
// and for the most pairs of nodes that wait. Other models are in query/query_contract_test.cpp.

/// Triangles around one vertex, each twice as large as the one before: the deepest possible tree.
Shape make_fan_of_all_sizes() {
  Shape fan;
  fan.influences_per_vertex = 1;
  for (int size = -55; size <= 55; ++size)
    for (std::uint32_t i = 0; i < 20; ++i) {
      const float length = std::ldexp(1.0f, size), width = length / static_cast<float>(2 + i);
      const auto first = static_cast<std::uint32_t>(fan.rest_positions.size());
      for (const Vec3& p : {Vec3{length, 0, width}, Vec3{length, width, 0}, Vec3{width, width, 0}})
        fan.rest_positions.push_back(p);
      fan.triangles.push_back({first, first + 1, first + 2});
    }
  fan.joints.resize(fan.rest_positions.size(), 0);
  fan.weights.resize(fan.rest_positions.size(), 1);
  return fan;
}

/// Returns the number of allocations of all queries of two poses of a model, after reserving.
std::size_t allocations(const Shape& shape, const std::vector<Matrix4>& palette_a,
                        const std::vector<Matrix4>& palette_b) {
  constexpr std::uint32_t kMaxContacts = 1 << 20;
  Pose a(*build_model(shape.view())), b(a.model());
  Scratch scratch;
  std::vector<Contact> contacts;
  std::vector<Vec3> positions(shape.rest_positions.size());
  contacts.reserve(kMaxContacts);
  a.reserve(), b.reserve(), scratch.reserve(kMaxContacts);
  const std::size_t before = test::allocation_count();
  for (const std::uint32_t max_contacts : {UINT32_MAX, 20u, 1u}) {
    EXPECT_TRUE(a.set_palette(palette_a) && b.set_palette(palette_b));
    contacts.clear();
    EXPECT_GT(collide(a, b, scratch, contacts, {max_contacts}).triangle_pairs, 0u);
    EXPECT_TRUE(intersects(a, b, scratch));
  }
  posed_vertices(a, positions);
  return test::allocation_count() - before;
}

TEST(Reserve, NoQueryAllocatesFromTheFirstOn) {
  const Shape limb = test::make_limb(60, 20, 5), fan = make_fan_of_all_sizes();
  test::on_each_instruction_set([&](InstructionSet) {
    Random random(80);
    const auto bent = test::bend_limb(random, 5, 0.3, {});
    EXPECT_EQ(allocations(limb, bent, bent), 0u);
    EXPECT_EQ(allocations(limb, bent, test::bend_limb(random, 5, 0.3, {0.05f, 0, 0})), 0u);
    EXPECT_EQ(allocations(fan, std::vector<Matrix4>(1), std::vector<Matrix4>(1)), 0u);
  });
  EXPECT_GT(test::allocation_count(), 0u) << "the counter must count";
}

// The cost of morph targets: nothing unless an active target displaces vertices that a query
// visits.

using test::brute_force;

/// Two long limbs, crossed at their lower ends. Targets displace the upper ends (0, 2, 4 ...) or
/// the lower ends (1, 3, 5 ...); the last one displaces everything.
struct CrossedLimbs {
  static constexpr std::uint32_t kTargets = 41;

  CrossedLimbs() {
    shape.morph_begin = {0};
    for (std::uint32_t m = 0; m < kTargets; ++m) {
      for (std::uint32_t v = 0; v < shape.rest_positions.size(); ++v) {
        const float y = shape.rest_positions[v].y;
        if (m + 1 < kTargets && (m % 2 == 0 ? y < 0.7f : y > 0.3f)) continue;
        shape.morph_vertices.push_back(v);
        shape.morph_displacements.push_back({0.001f, 0, 0.0005f});
      }
      shape.morph_begin.push_back(static_cast<std::uint32_t>(shape.morph_vertices.size()));
    }
    a.emplace(*build_model(shape.view()));
    b.emplace(a->model());
    Matrix4 turned;  // about z
    turned.m[0] = turned.m[5] = 0, turned.m[1] = 1, turned.m[4] = -1;
    EXPECT_TRUE(b->set_palette(std::vector<Matrix4>(6, turned)));
  }

  /// The work of a query with these active targets. Expects as many contacts as without targets.
  QueryStats ask(const std::vector<std::uint32_t>& active, float weight = 1) {
    std::vector<float> weights(kTargets);
    for (const std::uint32_t m : active) weights[m] = weight;
    EXPECT_TRUE(a->set_morph_weights(weights));
    EXPECT_TRUE(b->set_morph_weights(weights));
    std::vector<Contact> contacts;
    const QueryStats work = collide(*a, *b, scratch, contacts);
    EXPECT_FALSE(contacts.empty());
    EXPECT_EQ(contacts, brute_force(shape, *a, shape, *b));
    return work;
  }

  Shape shape = test::make_limb(300, 12, 6);
  std::optional<Pose> a, b;
  Scratch scratch;
};

TEST(MorphCollide, CostsNothingWhereNoActiveTargetIs) {
  CrossedLimbs limbs;
  const QueryStats without = limbs.ask({});
  const QueryStats elsewhere = limbs.ask({0, 2, 4, 6, 8});
  EXPECT_EQ(without.displacements, 0u);
  EXPECT_EQ(elsewhere.displacements, 0u);
  EXPECT_EQ(elsewhere.posed_vertices, without.posed_vertices);
  EXPECT_EQ(elsewhere.node_pairs, without.node_pairs);
  EXPECT_EQ(elsewhere.refits, without.refits);
}

TEST(MorphCollide, CostGrowsWithActiveTargetsThatDisplaceWhatIsVisited) {
  CrossedLimbs limbs;
  const float tiny = 1e-9f;  // moves nothing, but is added nevertheless
  const QueryStats one = limbs.ask({1}, tiny);
  const QueryStats five = limbs.ask({1, 3, 5, 7, 9}, tiny);
  const QueryStats mixed = limbs.ask({0, 1, 2, 3, 4, 5, 6, 7, 8, 9}, tiny);
  EXPECT_GT(one.displacements, 0u);
  EXPECT_EQ(one.displacements, one.posed_vertices) << "once for each vertex";
  EXPECT_EQ(five.displacements, 5 * one.displacements);
  EXPECT_EQ(mixed.displacements, five.displacements);
  EXPECT_LT(one.posed_vertices, limbs.shape.rest_positions.size() / 2);
}

TEST(MorphCollide, PosingAllVerticesAllocatesNothing) {
  CrossedLimbs limbs;
  ASSERT_TRUE(limbs.a->set_morph_weights(std::vector<float>(CrossedLimbs::kTargets, 0.5f)));
  std::vector<Vec3> posed(limbs.shape.rest_positions.size());
  const std::size_t before = test::allocation_count();
  posed_vertices(*limbs.a, posed);
  EXPECT_EQ(test::allocation_count(), before);
  EXPECT_NE(posed[0], limbs.shape.rest_positions[0]);
}

}  // namespace
}  // namespace pelt

/// Queries of models with morph targets: exact in any order of setters and queries. Targets cost
/// nothing unless an active target displaces vertices that a query visits.

#include <pelt/crowd.hpp>

#include "contacts_of.hpp"
#include "support/allocation_count.hpp"
#include "support/instruction_sets.hpp"
#include "support/skinned_shapes.hpp"

#include <gtest/gtest.h>

#include <optional>

namespace pelt {
namespace {

using test::brute_force;
using test::contacts_of;
using test::Morphing;
using test::Motion;
using test::Random;
using test::Shape;
using test::Weights;

/// Number of cases, and of cases with contacts.
struct Tally {
  int cases = 0, touching = 0;
};

void expect_exact(Random& random, const Shape& shape, Motion motion, Tally& tally) {
  Pose a(*build_model(shape.view())), b(a.model());
  Scratch scratch;
  const std::uint32_t joints = shape.joint_count, targets = shape.morph_target_count();
  for (const Morphing morphing : test::kAllMorphings) {
    ASSERT_TRUE(a.set_morph_weights(test::make_morph_weights(random, targets, morphing)));
    ASSERT_TRUE(a.set_palette(test::make_palette(random, joints, motion, 1)));
    ASSERT_TRUE(b.set_palette(test::make_palette(random, joints, motion, 1)));
    ASSERT_TRUE(b.set_morph_weights(test::make_morph_weights(random, targets, morphing)));
    const auto expected = brute_force(shape, a, shape, b);
    ASSERT_EQ(contacts_of(a, b, scratch), expected);
    ++tally.cases;
    tally.touching += !expected.empty();
    // Changes only the weights, not the palettes.
    ASSERT_TRUE(a.set_morph_weights(test::make_morph_weights(random, targets, Morphing::all)));
    ASSERT_EQ(contacts_of(a, b, scratch), brute_force(shape, a, shape, b));
  }
}

TEST(MorphCollide, EqualsBruteForceOnSoups) {
  Tally tally;
  test::on_each_instruction_set([&](InstructionSet) {
    Random random(340);
    for (const Motion motion : {Motion::rigid, Motion::affine, Motion::collapsed, Motion::far_away})
      for (const Weights weights : {Weights::random, Weights::adversarial})
        for (const double size : {0.1, 3.0}) {
          Shape soup = test::make_soup(random, 120, 6, 4, weights);
          test::add_morph_targets(random, soup, 10, 0.3, size);
          expect_exact(random, soup, motion, tally);
        }
  });
  EXPECT_GT(tally.touching, tally.cases / 3);
}

TEST(MorphCollide, EqualsBruteForceOnLimbs) {
  Random random(341);
  Shape limb = test::make_limb(30, 12, 5);
  test::add_morph_targets(random, limb, 20, 0.1, 0.1);
  Pose a(*build_model(limb.view())), b(a.model());
  Scratch scratch;
  int touching = 0, apart = 0;
  for (int round = 0; round < 150; ++round) {
    const Morphing morphing = round % 2 == 0 ? Morphing::some : Morphing::all;
    ASSERT_TRUE(a.set_palette(test::bend_limb(random, 5, 0.4, {})));
    ASSERT_TRUE(b.set_palette(test::bend_limb(random, 5, 0.4, random.point(0.8))));
    ASSERT_TRUE(a.set_morph_weights(test::make_morph_weights(random, 20, morphing)));
    ASSERT_TRUE(b.set_morph_weights(test::make_morph_weights(random, 20, morphing)));
    const auto expected = brute_force(limb, a, limb, b);
    ASSERT_EQ(contacts_of(a, b, scratch), expected);
    ++(expected.empty() ? apart : touching);
  }
  EXPECT_GT(touching, 30);
  EXPECT_GT(apart, 10);
}

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

TEST(MorphCollide, ReservedPosesAllocateNothing) {
  CrossedLimbs limbs;
  limbs.a->reserve();
  limbs.b->reserve();
  limbs.scratch.reserve(10'000);
  const std::vector<float> weights(CrossedLimbs::kTargets, 0.5f);
  std::vector<Contact> contacts;
  contacts.reserve(10'000);
  const std::size_t before = test::allocation_count();
  EXPECT_TRUE(limbs.a->set_morph_weights(weights));
  EXPECT_TRUE(limbs.b->set_morph_weights(weights));
  const QueryStats work = collide(*limbs.a, *limbs.b, limbs.scratch, contacts);
  EXPECT_EQ(test::allocation_count(), before);
  EXPECT_GT(work.displacements, 1000u);
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

TEST(MorphCollide, CrowdsSeeTheWeightsOfTheirInstances) {
  Random random(342);
  Shape limb = test::make_limb(30, 12, 5);
  test::add_morph_targets(random, limb, 12, 0.2, 0.3);
  const SkinnedModel model = *build_model(limb.view());
  Crowd crowd;
  std::vector<Pose> poses;
  for (std::uint32_t i = 0; i < 6; ++i) {
    ASSERT_EQ(crowd.add(model), i);
    poses.emplace_back(model);
  }
  Scratch scratch;
  std::size_t touching = 0;
  for (int round = 0; round < 20; ++round) {
    for (std::uint32_t i = 0; i < 6; ++i) {
      const auto palette = test::bend_limb(random, 5, 0.3, random.point(0.7));
      const auto weights = test::make_morph_weights(random, 12, test::kAllMorphings[round % 4]);
      ASSERT_TRUE(crowd.set_palette(i, palette) && poses[i].set_palette(palette));
      ASSERT_TRUE(crowd.set_morph_weights(i, weights) && poses[i].set_morph_weights(weights));
    }
    EXPECT_FALSE(crowd.set_morph_weights(0, std::vector<float>(11)));
    std::vector<CrowdContact> found, expected;
    crowd.collide(found, {.threads = 2});
    for (std::uint32_t i = 0; i < 6; ++i)
      for (std::uint32_t j = i + 1; j < 6; ++j)
        for (const Contact& c : contacts_of(poses[i], poses[j], scratch))
          expected.push_back({i, j, c.triangle_a, c.triangle_b});
    ASSERT_EQ(found, expected);
    touching += !found.empty();
  }
  EXPECT_GT(touching, 10u);
}

}  // namespace
}  // namespace pelt

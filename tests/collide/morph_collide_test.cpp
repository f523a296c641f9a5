/// The cost of morph targets: nothing unless an active target displaces vertices that a query
/// visits.

#include "contacts_of.hpp"
#include "support/allocation_count.hpp"
#include "support/skinned_shapes.hpp"

#include <gtest/gtest.h>

#include <optional>

namespace pelt {
namespace {

using test::brute_force;
using test::Shape;

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

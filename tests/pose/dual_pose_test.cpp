/// Poses of models with dual quaternion skinning: opened nodes have the bits of the definition, and
/// queries find what brute force finds.

#include "model/unpack.hpp"
#include "pose/open_node.hpp"
#include "pose/pose.hpp"
#include "skin/skin.hpp"
#include "support/dual_shapes.hpp"
#include "support/instruction_sets.hpp"

#include <pelt/bounds.hpp>
#include <pelt/collide.hpp>
#include <pelt/model.hpp>
#include <pelt/pose.hpp>

#include "geometry/triangle_pair.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>

namespace pelt {
namespace {

using detail::Node;
using detail::Tree;
using test::on_each_instruction_set;
using test::Random;
using test::Turns;
using test::Weights;

void expect_bits(const float* posed, const Vec3& expected) {
  ASSERT_EQ(std::bit_cast<std::uint32_t>(posed[0]), std::bit_cast<std::uint32_t>(expected.x));
  ASSERT_EQ(std::bit_cast<std::uint32_t>(posed[1]), std::bit_cast<std::uint32_t>(expected.y));
  ASSERT_EQ(std::bit_cast<std::uint32_t>(posed[2]), std::bit_cast<std::uint32_t>(expected.z));
}

void expect_pools(Pose& pose) {
  const Tree& tree = pose.model().detail().tree;
  const detail::SkinnedMesh vertices = detail::unpack_vertices(tree);
  const detail::PosedTree posed = pose.detail().posed_tree();
  make_table(posed);
  open_all(posed);
  for (std::uint32_t n = 0; n < tree.nodes.size(); ++n)
    for (std::uint32_t v = 0; v < tree.nodes[n].vertex_count; ++v)
      expect_bits(posed.opened[n]->positions + 4 * v,
                  scalar::posed_vertex(vertices, posed.palette, tree.nodes[n].first_vertex + v));
}

TEST(DualPose, OpenedNodesHaveTheBitsOfTheDefinition) {
  Random random(90);
  for (const Turns turns : test::kAllTurns)
    for (const std::uint32_t influences : {1u, 2u, 4u, 16u}) {
      test::Shape soup = test::make_soup(random, 250, 20, influences, Weights::adversarial);
      test::add_morph_targets(random, soup, 3, 0.3, 0.2);
      Pose pose(*build_model(soup.view(), test::kDual));
      const auto palette = test::random_rigid_palette(random, 20, turns, 2);
      for (const test::Morphing morphing : {test::Morphing::none, test::Morphing::some}) {
        ASSERT_TRUE(pose.set_morph_weights(test::make_morph_weights(random, 3, morphing)));
        on_each_instruction_set([&](InstructionSet) {
          ASSERT_TRUE(pose.set_palette(palette));
          expect_pools(pose);
        });
      }
    }
}

/// Two limbs, one of them with linear blend skinning in every second round.
struct Limbs {
  test::Shape shape_a = test::make_limb(24, 10, 5), shape_b = test::make_limb(17, 9, 4);
  Pose a = Pose(*build_model(shape_a.view(), test::kDual));
  Pose b = Pose(*build_model(shape_b.view(), test::kDual));
  Pose linear = Pose(*build_model(shape_b.view()));
  Scratch scratch;

  static std::vector<Matrix4> bent_and_twisted(Random& random, std::uint32_t joints, Vec3 at) {
    const double angle = random.uniform(-1.6, 1.6);
    if (random.chance(0.3)) return test::twist_limb(joints, 2 * angle, at);
    return random.chance(0.1) ? test::random_rigid_palette(random, joints, Turns::any, 0.2)
                              : test::bend_limb(random, joints, angle / 2, at);
  }

  void move(Random& random, double distance) {
    ASSERT_TRUE(a.set_palette(bent_and_twisted(random, 5, {})));
    const auto palette = bent_and_twisted(random, 4, random.point(distance));
    ASSERT_TRUE(b.set_palette(palette));
    ASSERT_TRUE(linear.set_palette(palette));
  }
};

std::vector<Vec3> positions_of(const Pose& pose) {
  std::vector<Vec3> posed(pose.model().vertex_count());
  posed_vertices(pose, posed);
  return posed;
}

using Pairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

Pairs brute_force(const test::Shape& a, const Pose& pose_a, const test::Shape& b,
                  const Pose& pose_b) {
  const std::vector<Vec3> p = positions_of(pose_a), q = positions_of(pose_b);
  Pairs pairs;
  for (std::uint32_t s = 0; s < a.triangles.size(); ++s)
    for (std::uint32_t t = 0; t < b.triangles.size(); ++t) {
      const Triangle &x = a.triangles[s], &y = b.triangles[t];
      if (detail::triangles_intersect({p[x[0]], p[x[1]], p[x[2]]}, {q[y[0]], q[y[1]], q[y[2]]}))
        pairs.push_back({s, t});
    }
  return pairs;
}

Pairs contacts_of(Pose& a, Pose& b, Scratch& scratch) {
  std::vector<Contact> contacts;
  collide(a, b, scratch, contacts);
  Pairs pairs;
  for (const Contact& contact : contacts) pairs.push_back({contact.triangle_a, contact.triangle_b});
  return pairs;
}

TEST(DualPose, ContactsEqualBruteForce) {
  Random random(91);
  Limbs limbs;
  int touching = 0, apart = 0;
  for (int round = 0; round < 200; ++round) {
    limbs.move(random, 0.4);
    Pose& b = round % 2 == 0 ? limbs.b : limbs.linear;
    const Pairs expected = brute_force(limbs.shape_a, limbs.a, limbs.shape_b, b);
    ASSERT_EQ(contacts_of(limbs.a, b, limbs.scratch), expected) << "round " << round;
    ASSERT_EQ(check_bounds(limbs.a), "");
    ASSERT_EQ(check_bounds(b), "");
    ++(expected.empty() ? apart : touching);
  }
  std::printf("%d rounds with contacts, %d without\n", touching, apart);
  EXPECT_GT(touching, 40);
  EXPECT_GT(apart, 40);
}

TEST(DualPose, PreparedModelsKeepTheirSkinning) {
  Random random(93);
  Limbs limbs;
  const auto loaded = load_model(save_model(limbs.a.model()));
  ASSERT_TRUE(loaded) << loaded.error().message;
  EXPECT_EQ(loaded->skinning(), Skinning::dual_quaternion);
  EXPECT_EQ(save_model(*loaded), save_model(limbs.a.model()));
  Pose pose(*loaded);
  for (int round = 0; round < 10; ++round) {
    const auto palette = Limbs::bent_and_twisted(random, 5, {});
    ASSERT_TRUE(pose.set_palette(palette));
    ASSERT_TRUE(limbs.a.set_palette(palette));
    ASSERT_EQ(positions_of(pose), positions_of(limbs.a));
    ASSERT_EQ(check_bounds(pose), "");
  }
}

TEST(DualPose, BoundsAndSpheresEncloseAllVertices) {
  Random random(92);
  Limbs limbs;
  const VertexGroups groups = group_by_joint(limbs.a.model());
  for (int round = 0; round < 100; ++round) {
    limbs.move(random, 0.4);
    Bounds found;
    bounds(limbs.a, found, static_cast<std::uint32_t>(round % 3));
    for (const Vec3& p : positions_of(limbs.a)) {
      ASSERT_TRUE(found.box.low.x <= p.x && p.x <= found.box.high.x);
      ASSERT_TRUE(found.box.low.y <= p.y && p.y <= found.box.high.y);
      ASSERT_TRUE(found.box.low.z <= p.z && p.z <= found.box.high.z);
      const double x = double{p.x} - double{found.sphere.centre.x};
      const double y = double{p.y} - double{found.sphere.centre.y};
      const double z = double{p.z} - double{found.sphere.centre.z};
      ASSERT_LE(std::sqrt(x * x + y * y + z * z), double{found.sphere.radius});
    }
    for (std::uint32_t g = 0; g < groups.count(); ++g) {
      Box loose, exact;
      group_bounds(limbs.a, groups, g, loose);
      exact_group_bounds(limbs.a, groups, g, exact);
      ASSERT_TRUE(loose.low.x <= exact.low.x && exact.high.x <= loose.high.x);
      ASSERT_TRUE(loose.low.y <= exact.low.y && exact.high.y <= loose.high.y);
      ASSERT_TRUE(loose.low.z <= exact.low.z && exact.high.z <= loose.high.z);
    }
  }
}

}  // namespace
}  // namespace pelt

/// Poses of models with dual quaternion skinning: opened nodes have the bits of the definition,
/// also of loaded models.

#include <pelt/asset.hpp>
#include <pelt/model.hpp>
#include <pelt/pose.hpp>
#include <pelt/self.hpp>

#include "model/unpack.hpp"
#include "pose/open_node.hpp"
#include "pose/pose.hpp"
#include "scenes/creature.hpp"
#include "scenes/demo.hpp"
#include "self/self_brute_force.hpp"
#include "skin/skin.hpp"
#include "support/brute_force.hpp"
#include "support/dual_shapes.hpp"
#include "support/instruction_sets.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>

namespace pelt {
namespace {

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

TEST(DualPose, PreparedModelsKeepTheirSkinning) {
  Random random(93);
  const SkinnedModel built = *build_model(test::make_limb(24, 10, 5).view(), test::kDual);
  const auto loaded = load_model(save_model(built));
  ASSERT_TRUE(loaded) << loaded.error().message;
  EXPECT_EQ(loaded->skinning(), Skinning::dual_quaternion);
  EXPECT_EQ(save_model(*loaded), save_model(built));
  Pose pose(*loaded), original(built);
  for (int round = 0; round < 10; ++round) {
    const auto palette = test::twist_limb(5, random.uniform(-3.2, 3.2), {});
    ASSERT_TRUE(pose.set_palette(palette));
    ASSERT_TRUE(original.set_palette(palette));
    ASSERT_EQ(test::positions_of(pose), test::positions_of(original));
    ASSERT_EQ(check_bounds(pose), "");
  }
}

}  // namespace
}  // namespace pelt

// Characters with dual quaternion skinning that walk and twist an arm, against brute force.
namespace pelt::test {
namespace {

const asset::Asset& creature() {
  static const asset::Asset asset = *scenes::make_creature({4000, 40, 3});
  return asset;
}

/// The palette of the walk at a time, turned and placed.
std::vector<Matrix4> walking(float seconds, double turn, const Vec3& at) {
  std::vector<Matrix4> palette(creature().joints.size());
  asset::SampleScratch scratch;
  asset::sample_palette(creature(), creature().find_clip("walk"), seconds,
                        rotation_about({0, 1, 0}, turn, {}, at), scratch, palette);
  return palette;
}

Pose posed(const std::vector<Matrix4>& palette) {
  static const SkinnedModel model = *build_model(creature().mesh(), kDual);
  Pose pose(model);
  EXPECT_TRUE(pose.set_palette(palette));
  return pose;
}

std::vector<Contact> brute_force(const Pose& a, const Pose& b) {
  return test::brute_force(creature().triangles, a, creature().triangles, b);
}

TEST(DualCreature, ContactsOfWalkersEqualBruteForce) {
  Random random(170);
  std::size_t contacts = 0;
  int apart = 0;
  for (int round = 0; round < 12; ++round) {
    const double distance = random.uniform(0, 0.8);
    Pose a = posed(round % 3 == 0 ? scenes::twisted_arm(creature(), random.uniform(-0.49, 0.49))
                                  : walking(random.uniformf(0, 1), 0, {}));
    Pose b = posed(walking(random.uniformf(0, 1), random.uniform(0, 6.28),
                           {random.uniformf(-0.2, 0.2), 0, static_cast<float>(distance)}));
    const std::vector<Contact> expected = brute_force(a, b);
    on_each_instruction_set([&](InstructionSet) {
      Scratch scratch;
      a.reserve(), b.reserve();  // closes all nodes
      ASSERT_EQ(contacts_of(a, b, scratch), expected) << "round " << round;
    });
    EXPECT_EQ(check_bounds(a), "");
    EXPECT_EQ(check_bounds(b), "");
    contacts += expected.size();
    apart += expected.empty();
  }
  EXPECT_GT(contacts, 1000u);
  EXPECT_GT(apart, 0);
}

/// The twisted arm of a creature whose other joints each turn by an angle about their rest places.
std::vector<Matrix4> crumpled(Random axes, double turns, double angle) {
  std::vector<Matrix4> palette = scenes::twisted_arm(creature(), turns);
  for (std::size_t j = 0; j < palette.size(); ++j) {
    const auto& bind = creature().joints[j].inverse_bind.m;
    const Vec3 axis = axes.point(1), centre = {-bind[12], -bind[13], -bind[14]};
    if (palette[j] == Matrix4{}) palette[j] = rotation_about(axis, angle, centre, {});
  }
  return palette;
}

TEST(DualCreature, SelfContactsOfATwistingArmEqualBruteForce) {
  const Random axes(171);
  const std::vector<std::uint32_t> surface = surface_vertices(creature().mesh());
  Pose pose = posed(scenes::twisted_arm(creature(), 0));
  const SelfFilter filter = *build_self_filter(pose.model());
  SelfTracker tracker(filter);
  Scratch scratch;
  std::size_t contacts = 0;
  int changes = 0;
  std::vector<Contact> last;
  for (int frame = 0; frame < 30; ++frame) {
    const double turns = 0.49 * std::sin(0.3 * frame);
    ASSERT_TRUE(pose.set_palette(crumpled(axes, turns, 0.04 * frame)));
    const std::vector<Contact> expected =
        sweep_self(posed_triangles(creature().mesh(), surface, pose));
    ASSERT_EQ(self_contacts_of(pose, filter, scratch), expected) << "frame " << frame;
    std::vector<Contact> tracked;
    self_collide(pose, tracker, scratch, tracked);
    ASSERT_EQ(tracked, expected) << "frame " << frame;
    contacts += expected.size();
    changes += expected != last;
    last = expected;
  }
  EXPECT_GT(contacts, 1000u);
  EXPECT_GT(changes, 15);
}

}  // namespace
}  // namespace pelt::test

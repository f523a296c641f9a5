/// Poses of models with dual quaternion skinning: opened nodes have the bits of the definition,
/// also of loaded models.

#include "model/unpack.hpp"
#include "pose/open_node.hpp"
#include "pose/pose.hpp"
#include "skin/skin.hpp"
#include "support/brute_force.hpp"
#include "support/dual_shapes.hpp"
#include "support/instruction_sets.hpp"

#include <pelt/model.hpp>
#include <pelt/pose.hpp>

#include <gtest/gtest.h>

#include <bit>

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

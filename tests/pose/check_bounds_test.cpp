#include <pelt/pose.hpp>

#include <pelt/collide.hpp>

#include "model/model.hpp"
#include "pose/pose.hpp"
#include "support/instruction_sets.hpp"
#include "support/skinned_shapes.hpp"

#include <gtest/gtest.h>

#include <memory>

namespace pelt {
namespace {

using detail::OpenedNode;
using test::Motion;
using test::Random;
using test::Weights;

Pose limb_pose() { return Pose(*build_model(test::make_limb(40, 12, 5).view())); }

/// The first of two crossing limbs, after a query.
Pose queried_limb() {
  Pose limb = limb_pose(), other = limb_pose();
  Random random(1);
  EXPECT_TRUE(limb.set_palette(test::bend_limb(random, 5, 0.3, {})));
  EXPECT_TRUE(other.set_palette(test::bend_limb(random, 5, -0.3, {0.02f, 0.1f, 0})));
  Scratch scratch;
  std::vector<Contact> contacts;
  collide(limb, other, scratch, contacts);
  EXPECT_FALSE(contacts.empty());
  return limb;
}

TEST(CheckBounds, FindsNothingInAnyPoseOnAnyTarget) {
  test::on_each_instruction_set([](InstructionSet) {
    Random random(2);
    for (const Motion motion : {Motion::rigid, Motion::affine, Motion::collapsed, Motion::far_away})
      for (const Weights weights : {Weights::one_joint, Weights::random, Weights::adversarial})
        for (const std::uint32_t influences : {1u, 4u, 12u, 40u}) {
          const test::Shape shape = test::make_soup(random, 200, 50, influences, weights);
          Pose pose(*build_model(shape.view())), other(pose.model());
          ASSERT_EQ(check_bounds(pose), "");
          ASSERT_TRUE(pose.set_palette(test::make_palette(random, 50, motion, 2)));
          ASSERT_TRUE(other.set_palette(test::make_palette(random, 50, motion, 2)));
          Scratch scratch;
          intersects(pose, other, scratch);
          ASSERT_EQ(check_bounds(pose), "");
        }
  });
}

TEST(CheckBounds, NamesWhatQueriesLeftAndWhichIsTooSmall) {
  Pose pose = queried_limb();
  ASSERT_EQ(check_bounds(pose), "");
  detail::RootBox& root = pose.detail().root_box;
  ASSERT_TRUE(root.known);
  const float root_low = root.low[1];
  root.low[1] = 100;
  EXPECT_NE(check_bounds(pose).find("node 0: the box of the root 0 misses a vertex by "),
            std::string::npos);
  root.low[1] = root_low;

  const detail::Tree& tree = pose.model().detail().tree;
  const auto message_with = [&](float& bound, float value) {
    const float before = bound;
    bound = value;
    const std::string message = check_bounds(pose);
    bound = before;
    return message;
  };
  int clusters = 0, children = 0, triangles = 0;
  for (std::uint32_t n = 0; n < tree.nodes.size(); ++n) {
    auto* opened = const_cast<OpenedNode*>(pose.detail().opened[n]);
    if (!opened) continue;
    const std::string node = "node " + std::to_string(n) + ": the box of ";
    const auto expect_named = [&](const std::string& message, const std::string& bound,
                                  const char* axis) {
      EXPECT_EQ(message.find(node + bound + " misses a vertex by "), 0u) << message;
      EXPECT_NE(message.find(std::string(" along ") + axis), std::string::npos) << message;
    };
    expect_named(message_with(opened->all_high[2], -100), "all slots of node " + std::to_string(n),
                 "z");
    const detail::Node& data = tree.nodes[n];
    for (std::uint32_t slot = 0; slot < data.cluster_count; ++slot, ++clusters) {
      const std::uint32_t cluster = data.first_cluster + slot;
      expect_named(message_with(opened->low[0][slot], 100), "cluster " + std::to_string(cluster),
                   "x");
      detail::TriangleBoxes* boxes = opened->triangles[slot].load();
      if (!boxes) continue;
      const std::uint32_t triangle = tree.triangle_ids[tree.clusters[cluster].first_triangle];
      expect_named(message_with(boxes->high[1][0], -100), "triangle " + std::to_string(triangle),
                   "y");
      ++triangles;
    }
    for (std::uint32_t child = 0; child < data.child_count; ++child, ++children)
      expect_named(message_with(opened->low[2][data.cluster_count + child], NAN),
                   "child " + std::to_string(data.first_child + child), "z");
  }
  EXPECT_GT(clusters, 5);
  EXPECT_GT(children, 2);
  EXPECT_GT(triangles, 2);
}

TEST(CheckBounds, LooksAtNodesThatNoQueryHasOpened) {
  const SkinnedModel sound = *build_model(test::make_limb(40, 12, 5).view());
  const std::size_t count = sound.detail().tree.nodes.size();
  ASSERT_GT(count, 5u);
  for (std::size_t node = 0; node < count; ++node) {
    auto broken = std::make_shared<detail::Model>(sound.detail());
    broken->bounds.nodes[node].margin = -0.1f;
    EXPECT_NE(check_bounds(Pose(SkinnedModel(broken))), "") << "node " << node;
  }
}

TEST(CheckBounds, LeavesThePoseAsItIs) {
  const Pose pose = limb_pose();
  ASSERT_EQ(check_bounds(pose), "");
  EXPECT_FALSE(pose.detail().opened);
  EXPECT_FALSE(pose.detail().root_box.known);
}

}  // namespace
}  // namespace pelt

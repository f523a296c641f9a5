#include <pelt/asset.hpp>

#include <gtest/gtest.h>

namespace pelt::asset {
namespace {

using Numbers = std::vector<std::uint16_t>;

/// A chain of five nodes; those of the joints are 4, 1 and 3. A clip turns nodes 1 and 4.
Asset body_chain() {
  Asset asset;
  asset.nodes.resize(5);
  for (std::uint32_t node = 1; node < 5; ++node) asset.nodes[node].parent = node - 1;
  for (const std::uint32_t node : {4U, 1U, 3U}) asset.joints.push_back({node, Matrix4{}});
  asset.clips.emplace_back();
  for (const std::uint32_t node : {1U, 4U})
    asset.clips[0].channels.push_back({node, Path::rotation, {}, {0}, {1, 0, 0, 0}});
  return asset;
}

TEST(JointBodies, JoinWhatNoClipMoves) {
  const JointBodies bodies = joint_bodies(body_chain());
  EXPECT_EQ(bodies.of_joints, (Numbers{0, 1, 1})) << "node 3 follows node 1";
  EXPECT_EQ(bodies.above, (Numbers{1, kNoJoint, kNoJoint}));
}

TEST(JointBodies, AreJointsIfNothingMoves) {
  Asset asset = body_chain();
  asset.clips.clear();
  const JointBodies bodies = joint_bodies(asset);
  EXPECT_EQ(bodies.of_joints, (Numbers{0, 1, 2}));
  EXPECT_EQ(bodies.above, (Numbers{2, kNoJoint, 1})) << "nodes without joints are skipped";
}

TEST(JointBodies, OfNoJointsAreEmpty) {
  EXPECT_TRUE(joint_bodies({}).of_joints.empty());
  EXPECT_TRUE(joint_bodies({}).above.empty());
}

}  // namespace
}  // namespace pelt::asset

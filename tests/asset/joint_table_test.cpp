#include "asset/joint_table.hpp"

#include <pelt/asset.hpp>

#include "support/gltf_builder.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace pelt::asset {
namespace {

using test::GltfBuilder;
using test::json;
using test::refused;

TEST(JointTable, HasTheSkinsJointsInOrder) {
  const Asset asset = test::paper_strip().read();
  ASSERT_EQ(asset.joints.size(), 2u);
  EXPECT_EQ(asset.joint_name(0), "lower");
  EXPECT_EQ(asset.joint_name(1), "upper");
  EXPECT_EQ(asset.joints[0].inverse_bind, Matrix4{});
  EXPECT_EQ(asset.joints[1].inverse_bind.m[13], -1.5f);
}

TEST(JointTable, UsesIdentityIfThereAreNoMatrices) {
  GltfBuilder builder = test::paper_strip();
  builder.document["skins"][0].erase("inverseBindMatrices");
  const Asset asset = builder.read();
  EXPECT_EQ(asset.joints[1].inverse_bind, Matrix4{});
}

TEST(JointTable, AllowsMoreMatricesThanJoints) {
  GltfBuilder builder = test::paper_strip();
  builder.document["skins"][0]["joints"] = {1};
  for (std::size_t v = 0; v < 8; ++v) builder.set_value<std::uint8_t>(2, 4 * v + 1, 0);
  const Asset asset = builder.read();
  EXPECT_EQ(asset.joints.size(), 1u);
}

TEST(JointTable, RefusesFewerMatricesThanJoints) {
  GltfBuilder builder = test::paper_strip();
  builder.accessor(4)["count"] = 1;
  EXPECT_TRUE(refused(builder.load(), {"accessor 4", "inverseBindMatrices of skin 0 \"rig\"",
                                       "1 matrices for 2 joints"}));
}

TEST(JointTable, RefusesMatricesThatAreNotAffine) {
  GltfBuilder builder = test::paper_strip();
  builder.set_value<float>(4, 16 + 15, 2);
  EXPECT_TRUE(refused(builder.load(), {"accessor 4", "matrix 1", "0 0 0 1"}));
}

TEST(JointTable, MakesTheLastRowExact) {
  GltfBuilder builder = test::paper_strip();
  builder.set_value<float>(4, 16 + 3, 1e-7f);
  builder.set_value<float>(4, 16 + 15, 0.9999999f);
  const Asset asset = builder.read();
  EXPECT_EQ(asset.joints[1].inverse_bind.m[3], 0);
  EXPECT_EQ(asset.joints[1].inverse_bind.m[15], 1);
}

TEST(JointTable, RefusesMatricesThatAreNotFinite) {
  GltfBuilder builder = test::paper_strip();
  builder.set_value<float>(4, 16 + 5, std::numeric_limits<float>::infinity());
  EXPECT_TRUE(refused(builder.load(), {"accessor 4", "element 1 is infinite"}));
}

/// The strip twice, the second time with another skin.
GltfBuilder two_skins(const std::vector<float>& second_matrices) {
  GltfBuilder builder = test::paper_strip();
  const std::size_t matrices = builder.add_accessor(second_matrices, "MAT4");
  builder.add("skins", {{"joints", {2, 1}}, {"inverseBindMatrices", matrices}});
  builder.add("nodes", {{"name", "copy"}, {"mesh", 0}, {"skin", 1}});
  builder.document["scenes"][0]["nodes"].push_back(3);
  return builder;
}

TEST(JointTable, KeepsJointsThatSkinsShareOnce) {
  const std::vector<float> swapped = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -1.5f, 0, 1,
                                      1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0,     0, 1};
  const Asset asset = two_skins(swapped).read();
  EXPECT_EQ(asset.joints.size(), 2u);
  // The skin of the copy lists the joints in reverse order.
  EXPECT_EQ(asset.joint_indices[2 * 2], 0);
  EXPECT_EQ(asset.joint_indices[2 * (8 + 2)], 1);
}

TEST(JointTable, KeepsJointsApartThatOnlyShareTheirNode) {
  std::vector<float> other(32);
  for (std::size_t i = 0; i < 4; ++i) other[5 * i] = other[16 + 5 * i] = 1;
  other[12] = 0.25f;
  const Asset asset = two_skins(other).read();
  ASSERT_EQ(asset.joints.size(), 3u);
  EXPECT_EQ(asset.joint_name(2), "upper");
  EXPECT_EQ(asset.joints[2].inverse_bind.m[12], 0.25f);
}

TEST(JointTable, AllowsOneNodeTwiceInOneSkin) {
  GltfBuilder builder = test::paper_strip();
  builder.document["skins"][0] = {{"joints", {1, 1}}};
  const Asset asset = builder.read();
  EXPECT_EQ(asset.joints.size(), 1u);
}

TEST(JointTable, RefusesMoreJointsThanNumbers) {
  GltfBuilder builder = test::stone();
  json nodes = json::array(), roots = json::array();
  for (int i = 0; i <= 65535; ++i) {
    nodes.push_back({{"mesh", 0}});
    roots.push_back(i);
  }
  builder.document["nodes"] = nodes;
  builder.document["scenes"][0]["nodes"] = roots;
  const Result<Asset> asset = builder.load();
  EXPECT_TRUE(refused(asset, {"node 65535", "more than 65535 joints"}));
  EXPECT_EQ(asset.error().code, ErrorCode::unsupported);
}

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

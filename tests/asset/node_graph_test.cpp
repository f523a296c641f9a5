#include "asset/node_graph.hpp"

#include "asset/rigid_nodes.hpp"
#include "support/gltf_builder.hpp"

#include <gtest/gtest.h>

namespace pelt::asset {
namespace {

using test::GltfBuilder;
using test::json;
using test::refused;

/// A stone's document with these nodes after the stone; node 0 remains "stone".
GltfBuilder stone_with_nodes(const std::vector<json>& nodes, const json& roots) {
  GltfBuilder builder = test::stone();
  for (const json& node : nodes) builder.add("nodes", node);
  builder.document["scenes"][0]["nodes"] = roots;
  return builder;
}

std::vector<std::string> node_names(const Asset& asset) {
  std::vector<std::string> names;
  for (const Node& node : asset.nodes) names.push_back(node.name);
  return names;
}

std::vector<std::uint32_t> parents(const Asset& asset) {
  std::vector<std::uint32_t> all;
  for (const Node& node : asset.nodes) all.push_back(node.parent);
  return all;
}

using Names = std::vector<std::string>;
using Parents = std::vector<std::uint32_t>;

TEST(NodeGraph, IsDepthFirstThroughTheSceneAndThenTheRest) {
  const GltfBuilder builder = stone_with_nodes({{{"name", "last"}},
                                                {{"name", "middle"}, {"children", {0, 1}}},
                                                {{"name", "root"}, {"children", {2, 4}}},
                                                {{"name", "leaf"}},
                                                {{"name", "elsewhere"}, {"children", {6}}},
                                                {{"name", "below"}}},
                                               {3});
  const Asset asset = builder.read();
  EXPECT_EQ(node_names(asset),
            (Names{"root", "middle", "stone", "last", "leaf", "elsewhere", "below"}));
  EXPECT_EQ(parents(asset), (Parents{kNoParent, 0, 1, 1, 0, kNoParent, 5}));
}

TEST(NodeGraph, ReadsTheSceneThatTheFileNames) {
  GltfBuilder builder = test::stone();
  builder.add("nodes", {{"name", "other"}, {"mesh", 0}});
  builder.add("scenes", {{"nodes", {1}}});
  builder.document["scene"] = 1;
  EXPECT_EQ(builder.load()->parts.front().node, "other");
  builder.document.erase("scene");
  EXPECT_EQ(builder.load()->parts.front().node, "stone");
}

TEST(NodeGraph, WithoutScenesShowsAllRoots) {
  GltfBuilder builder = stone_with_nodes({{{"name", "root"}, {"children", {0}}}}, {1});
  builder.document.erase("scenes");
  const Asset asset = builder.read();
  EXPECT_EQ(node_names(asset), (Names{"root", "stone"}));
}

TEST(NodeGraph, RefusesTwoParents) {
  const GltfBuilder builder = stone_with_nodes(
      {{{"name", "one"}, {"children", {0}}}, {{"name", "two"}, {"children", {0}}}}, {1, 2});
  EXPECT_TRUE(refused(builder.load(), {"node 0 \"stone\"", "node 1 \"one\"", "node 2 \"two\""}));
}

TEST(NodeGraph, RefusesAChildListedTwice) {
  const GltfBuilder builder = stone_with_nodes({{{"name", "one"}, {"children", {0, 0}}}}, {1});
  EXPECT_TRUE(refused(builder.load(), {"node 0 \"stone\" is a child of both"}));
}

TEST(NodeGraph, RefusesCycles) {
  EXPECT_TRUE(refused(stone_with_nodes({{{"name", "self"}, {"children", {1}}}}, {0}).load(),
                      {"node 1 \"self\"", "cycle"}));
  EXPECT_TRUE(
      refused(stone_with_nodes(
                  {{{"name", "a"}, {"children", {2}}}, {{"name", "b"}, {"children", {1}}}}, {0})
                  .load(),
              {"node 1 \"a\"", "cycle"}));
  EXPECT_TRUE(
      refused(stone_with_nodes(
                  {{{"name", "a"}, {"children", {2}}}, {{"name", "b"}, {"children", {1}}}}, {1})
                  .load(),
              {"node 1 \"a\"", "root of the scene and a child"}));
}

TEST(NodeGraph, RefusesARootListedTwice) {
  EXPECT_TRUE(refused(stone_with_nodes({}, {0, 0}).load(), {"node 0 \"stone\"", "twice"}));
}

TEST(NodeGraph, AcceptsAChainOfAnyLength) {
  constexpr std::uint32_t kLength = 100000;
  GltfBuilder builder = test::stone();
  builder.document["nodes"][0]["children"] = {1};
  json nodes = builder.document["nodes"];
  for (std::uint32_t i = 1; i < kLength; ++i) nodes.push_back({{"children", {i + 1}}});
  nodes.push_back(json::object());
  builder.document["nodes"] = nodes;
  const Asset asset = builder.read();
  ASSERT_EQ(asset.nodes.size(), kLength + 1);
  EXPECT_EQ(asset.nodes.back().parent, kLength - 1);
}

TEST(Nodes, KeepTheirTransforms) {
  GltfBuilder builder = test::stone();
  json& node = builder.document["nodes"][0];
  node["translation"] = {1, 2, 3};
  node["rotation"] = {0, 0.6, 0, 0.8};
  node["scale"] = {2, -1, 0};
  const Asset asset = builder.read();
  const Transform& local = asset.nodes[0].local;
  EXPECT_FALSE(asset.nodes[0].has_matrix);
  EXPECT_EQ(local.translation, (std::array<float, 3>{1, 2, 3}));
  EXPECT_EQ(local.rotation, (std::array<float, 4>{0, 0.6f, 0, 0.8f}));
  EXPECT_EQ(local.scale, (std::array<float, 3>{2, -1, 0}));
}

TEST(Nodes, NormaliseARotationThatIsSlightlyOff) {
  GltfBuilder builder = test::stone();
  builder.document["nodes"][0]["rotation"] = {0, 0, 0, 1.02};
  EXPECT_EQ(builder.load()->nodes[0].local.rotation, (std::array<float, 4>{0, 0, 0, 1}));
}

TEST(Nodes, KeepTheirMatrices) {
  GltfBuilder builder = test::stone();
  json& matrix = builder.document["nodes"][0]["matrix"];
  matrix = {1, 2, 3, 0, 4, 5, 6, 0, 7, 8, 9, 0, 10, 11, 12, 1};
  const Asset asset = builder.read();
  EXPECT_TRUE(asset.nodes[0].has_matrix);
  EXPECT_EQ(asset.nodes[0].matrix.m,
            (std::array<float, 16>{1, 2, 3, 0, 4, 5, 6, 0, 7, 8, 9, 0, 10, 11, 12, 1}));
  matrix[3] = 1e-9;
  EXPECT_EQ(builder.load()->nodes[0].matrix.m[3], 0);
  matrix[3] = 0.5;
  EXPECT_TRUE(refused(builder.load(), {"nodes[0].matrix", "last row"}));
}

using Nodes = std::vector<std::uint32_t>;

/// A chain of three nodes; node 2 is two units away from node 1.
Asset chain() {
  Asset asset;
  asset.nodes.resize(3);
  asset.nodes[1].parent = 0;
  asset.nodes[2].parent = 1;
  asset.nodes[2].local.translation = {0, 2, 0};
  asset.clips.emplace_back();
  return asset;
}

/// The highest nodes if a clip has these values for node 2. Node 1 is turned.
Nodes with_channel(Path path, const std::vector<float>& values,
                   Interpolation interpolation = Interpolation::linear) {
  Asset asset = chain();
  asset.clips[0].channels.push_back({1, Path::rotation, {}, {0}, {1, 0, 0, 0}});
  asset.clips[0].channels.push_back({2, path, interpolation, {0}, values});
  return rigid_nodes(asset);
}

const Nodes kRigid = {0, 1, 1}, kMoved = {0, 1, 2};

TEST(RigidNodes, AreTheirOwnWithoutMotion) {
  Asset asset = chain();
  EXPECT_EQ(rigid_nodes(asset), (Nodes{0, 1, 2}));
  asset.clips.clear();
  EXPECT_EQ(rigid_nodes(asset), (Nodes{0, 1, 2}));
}

TEST(RigidNodes, FollowTheNodeAboveThatMoves) {
  Asset asset = chain();
  asset.clips[0].channels.push_back({2, Path::rotation, {}, {0}, {1, 0, 0, 0}});
  EXPECT_EQ(rigid_nodes(asset), (Nodes{0, 0, 2}));
  EXPECT_EQ(with_channel(Path::rotation, {0, 0, 0, 1}), kRigid);
}

TEST(RigidNodes, IgnoreRoundingErrors) {
  EXPECT_EQ(with_channel(Path::rotation, {0, 0.003F, 0, 1}), kRigid);
  EXPECT_EQ(with_channel(Path::rotation, {0, -0.003F, 0, -1}), kRigid);
  EXPECT_EQ(with_channel(Path::rotation, {0, 0.006F, 0, 1}), kMoved);
  EXPECT_EQ(with_channel(Path::translation, {0, 2.005F, 0}), kRigid);
  EXPECT_EQ(with_channel(Path::translation, {0, 2.01F, 0}), kMoved);
  EXPECT_EQ(with_channel(Path::translation, {0, 2, 0, 0, 2, 0.1F}), kMoved);
  EXPECT_EQ(with_channel(Path::scale, {1, 1, 1.003F}), kRigid);
  EXPECT_EQ(with_channel(Path::scale, {1, 1, 1.01F}), kMoved);
}

TEST(RigidNodes, ReadTheValuesBetweenTangents) {
  EXPECT_EQ(
      with_channel(Path::translation, {0, 0, 0, 0, 2, 0, 0, 0, 0}, Interpolation::cubic_spline),
      kRigid);
  EXPECT_EQ(
      with_channel(Path::translation, {0, 0, 0, 0, 2, 0, 0, 0, 3}, Interpolation::cubic_spline),
      kMoved);
  EXPECT_EQ(
      with_channel(Path::translation, {0, 0, 0, 0, 3, 0, 0, 0, 0}, Interpolation::cubic_spline),
      kMoved);
}

TEST(RigidNodes, AreNotMovedByMorphTargets) { EXPECT_EQ(with_channel(Path::weights, {1}), kRigid); }

}  // namespace
}  // namespace pelt::asset

#include "asset/rigid_nodes.hpp"

#include <gtest/gtest.h>

namespace pelt::asset {
namespace {

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

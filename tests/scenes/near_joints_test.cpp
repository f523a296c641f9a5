#include "scenes/triangle_labels.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <utility>

namespace pelt::scenes {
namespace {

using Pairs = std::set<std::pair<int, int>>;

/// A character whose triangle t follows joint t and lies alone.
asset::Asset asset_with(const std::vector<std::uint32_t>& parents,
                        const std::vector<std::uint32_t>& joint_nodes) {
  asset::Asset asset;
  for (const std::uint32_t parent : parents) {
    asset.nodes.emplace_back();
    asset.nodes.back().parent = parent;
  }
  for (const std::uint32_t node : joint_nodes) {
    asset.joints.emplace_back();
    asset.joints.back().node = node;
    const auto first = static_cast<std::uint32_t>(asset.rest_positions.size());
    for (std::uint32_t k = 0; k < 3; ++k)
      asset.rest_positions.push_back({static_cast<float>(first + k), 0, 0});
    asset.triangles.push_back({first, first + 1, first + 2});
  }
  return asset;
}

/// Adds a clip that turns these nodes.
void add_clip(asset::Asset& asset, const std::vector<std::uint32_t>& nodes) {
  asset.clips.emplace_back();
  for (const std::uint32_t node : nodes)
    asset.clips.back().channels.push_back(
        {node, asset::Path::rotation, {}, {0, 1}, {0, 0, 0, 1, 0, 0.6F, 0, 0.8F}});
}

/// Gives two triangles a corner in common.
void join(asset::Asset& asset, std::uint32_t s, std::uint32_t t) {
  asset.rest_positions[asset.triangles[t][1]] = asset.rest_positions[asset.triangles[s][2]];
}

std::vector<std::uint16_t> own_joints(const asset::Asset& asset) {
  std::vector<std::uint16_t> joints(asset.joints.size());
  for (std::size_t j = 0; j < joints.size(); ++j) joints[j] = static_cast<std::uint16_t>(j);
  return joints;
}

/// Unordered pairs of bodies that are near in their zone only.
Pairs pairs_in_zones(const asset::Asset& asset) {
  Pairs pairs;
  for (const IndexPair& pair : near_joints(asset, own_joints(asset), {}).joint_pairs_in_zones)
    pairs.insert(std::minmax(pair.first, pair.second));
  return pairs;
}

/// Unordered pairs of bodies that are near everywhere. The triangles follow `main_joints`, or each
/// its own joint.
Pairs near_pairs(const asset::Asset& asset, std::vector<std::uint16_t> main_joints = {},
                 const std::vector<Contact>& at_rest = {}) {
  if (main_joints.empty()) main_joints = own_joints(asset);
  Pairs pairs;
  for (const IndexPair& pair : near_joints(asset, main_joints, at_rest).joint_pairs)
    pairs.insert(std::minmax(pair.first, pair.second));
  return pairs;
}

constexpr std::uint32_t kNone = asset::kNoParent;

TEST(NearJoints, AreAJointWithItselfAndTheNextJointAbove) {
  // A chain of the nodes 0 to 3, of which node 2 is no joint, and node 4 beside node 1.
  const asset::Asset asset = asset_with({kNone, 0, 1, 2, 0}, {0, 1, 3, 4});
  EXPECT_EQ(near_pairs(asset), (Pairs{{0, 0}, {1, 1}, {2, 2}, {3, 3}, {0, 1}, {1, 2}, {0, 3}}));
}

TEST(NearJoints, CountJointsOfOtherSkinsAtTheSameNodesAsOne) {
  const asset::Asset asset = asset_with({kNone, 0}, {0, 1, 0, 1});
  EXPECT_EQ(near_joints(asset, own_joints(asset), {}).bodies,
            (std::vector<std::uint16_t>{0, 1, 0, 1}));
  EXPECT_EQ(near_pairs(asset), (Pairs{{0, 0}, {1, 1}, {0, 1}}));
}

TEST(NearJoints, SkipJointsWithoutTriangles) {
  const asset::Asset asset = asset_with({kNone, 0, 1, 2}, {0, 1, 2, 3});
  const Pairs pairs = near_pairs(asset, {0, 0, 3, 3});
  EXPECT_TRUE(pairs.contains({0, 3}));
  EXPECT_FALSE(near_pairs(asset).contains({0, 3}));
}

TEST(NearJoints, CountJointsThatNoClipMovesAgainstEachOtherAsOne) {
  // A helmet, node 3, on the head, node 2, above the chest and the hips.
  asset::Asset asset = asset_with({kNone, 0, 1, 2}, {0, 1, 2, 3});
  EXPECT_FALSE(near_pairs(asset).contains({1, 3}));
  add_clip(asset, {1, 2});
  EXPECT_EQ(near_joints(asset, own_joints(asset), {}).bodies,
            (std::vector<std::uint16_t>{0, 1, 2, 2}));
  EXPECT_EQ(near_pairs(asset), (Pairs{{0, 0}, {1, 1}, {2, 2}, {0, 1}, {1, 2}}));
  add_clip(asset, {3});
  EXPECT_EQ(near_joints(asset, own_joints(asset), {}).bodies, own_joints(asset));
}

TEST(NearJoints, IncludeJointsAboveWhoseTrianglesShareACorner) {
  // The chest with two chains of a collarbone and an arm.
  asset::Asset asset = asset_with({kNone, 0, 1, 0, 3}, {0, 1, 2, 3, 4});
  const Pairs apart = near_pairs(asset);
  EXPECT_EQ(apart, (Pairs{{0, 0}, {1, 1}, {2, 2}, {3, 3}, {4, 4}, {0, 1}, {1, 2}, {0, 3}, {3, 4}}));
  EXPECT_EQ(pairs_in_zones(asset), Pairs{});
  join(asset, 0, 2);
  EXPECT_EQ(near_pairs(asset), apart);
  EXPECT_EQ(pairs_in_zones(asset), (Pairs{{0, 2}}));
  join(asset, 3, 1);  // the collarbones: neither is above the other
  EXPECT_EQ(near_pairs(asset), apart);
  EXPECT_EQ(pairs_in_zones(asset), (Pairs{{0, 2}}));
}

TEST(NearJoints, AreNearOnlyInTheZoneOfTheirJointIfTheyShareACorner) {
  asset::Asset asset = asset_with({kNone, 0, 1}, {0, 1, 2});
  join(asset, 0, 1);
  EXPECT_EQ(near_pairs(asset), (Pairs{{0, 0}, {1, 1}, {2, 2}, {1, 2}}));
  EXPECT_EQ(pairs_in_zones(asset), (Pairs{{0, 1}}));
  const std::vector<TriangleZone> zones = near_joints(asset, own_joints(asset), {}).zones;
  for (const auto& [triangle, zone] : zones) EXPECT_EQ(zone, 1);
  EXPECT_EQ(zones.size(), 2u);
  EXPECT_TRUE(near_pairs(asset, {}, {{0, 1}}).contains({0, 1})) << "everywhere if they touch";
}

TEST(NearJoints, IncludeJointsWhoseTrianglesTouchAtRest) {
  const asset::Asset asset = asset_with({kNone, 0, 0}, {0, 1, 2});
  EXPECT_FALSE(near_pairs(asset).contains({1, 2}));
  EXPECT_TRUE(near_pairs(asset, {}, {{2, 1}}).contains({1, 2}));
}

TEST(NearJoints, OfNoJointsAreNone) {
  EXPECT_TRUE(near_joints(asset_with({kNone}, {}), {}, {}).joint_pairs.empty());
}

}  // namespace
}  // namespace pelt::scenes

#include "scenes/near_joints.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <utility>

namespace pelt::scenes {
namespace {

/// Unordered pairs of joints.
std::set<std::pair<int, int>> near_pairs(const asset::Asset& asset) {
  std::set<std::pair<int, int>> pairs;
  for (const IndexPair& pair : near_joints(asset))
    pairs.insert(std::minmax(pair.first, pair.second));
  return pairs;
}

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
  }
  return asset;
}

TEST(NearJoints, AreAJointWithItselfAndTheNextJointAbove) {
  // A chain of the nodes 0 to 3, of which node 2 is no joint, and node 4 beside node 1.
  const asset::Asset asset = asset_with({asset::kNoParent, 0, 1, 2, 0}, {0, 1, 3, 4});
  EXPECT_EQ(near_pairs(asset), (std::set<std::pair<int, int>>{
                                   {0, 0}, {1, 1}, {2, 2}, {3, 3}, {0, 1}, {1, 2}, {0, 3}}));
}

TEST(NearJoints, IncludeJointsOfOtherSkinsAtTheSameNodes) {
  const asset::Asset asset = asset_with({asset::kNoParent, 0}, {0, 1, 0, 1});
  EXPECT_EQ(near_pairs(asset),
            (std::set<std::pair<int, int>>{
                {0, 0}, {1, 1}, {2, 2}, {3, 3}, {0, 2}, {1, 3}, {0, 1}, {0, 3}, {1, 2}, {2, 3}}));
}

TEST(NearJoints, OfNoJointsAreNone) {
  EXPECT_TRUE(near_joints(asset_with({asset::kNoParent}, {})).empty());
}

}  // namespace
}  // namespace pelt::scenes

#include "scenes/near_joints.hpp"

namespace pelt::scenes {
namespace {

using JointsOfNodes = std::vector<std::vector<std::uint16_t>>;

JointsOfNodes joints_of_nodes(const asset::Asset& asset) {
  JointsOfNodes joints(asset.nodes.size());
  for (std::size_t j = 0; j < asset.joints.size(); ++j)
    joints[asset.joints[j].node].push_back(static_cast<std::uint16_t>(j));
  return joints;
}

/// Returns the nearest node above that has joints, or kNoParent.
std::uint32_t joint_node_above(const asset::Asset& asset, const JointsOfNodes& joints,
                               std::uint32_t node) {
  do node = asset.nodes[node].parent;
  while (node != asset::kNoParent && joints[node].empty());
  return node;
}

}  // namespace

std::vector<IndexPair> near_joints(const asset::Asset& asset) {
  const JointsOfNodes joints = joints_of_nodes(asset);
  std::vector<IndexPair> pairs;
  for (std::size_t j = 0; j < asset.joints.size(); ++j) {
    const auto joint = static_cast<std::uint16_t>(j);
    const std::uint32_t node = asset.joints[j].node;
    for (const std::uint16_t other : joints[node]) pairs.push_back({joint, other});
    const std::uint32_t above = joint_node_above(asset, joints, node);
    if (above == asset::kNoParent) continue;
    for (const std::uint16_t other : joints[above]) pairs.push_back({joint, other});
  }
  return pairs;
}

}  // namespace pelt::scenes

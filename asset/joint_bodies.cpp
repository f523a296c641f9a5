#include "asset/rigid_nodes.hpp"

#include <optional>

namespace pelt::asset {
namespace {

/// The body of each node's joints, by the highest node that they never move against.
using Bodies = std::vector<std::optional<std::uint16_t>>;

Bodies bodies_of_nodes(const Asset& asset, const std::vector<std::uint32_t>& highest) {
  Bodies bodies(asset.nodes.size());
  for (std::size_t j = asset.joints.size(); j-- > 0;)
    bodies[highest[asset.joints[j].node]] = static_cast<std::uint16_t>(j);
  return bodies;
}

}  // namespace

JointBodies joint_bodies(const Asset& asset) {
  const std::vector<std::uint32_t> highest = rigid_nodes(asset);
  const Bodies bodies = bodies_of_nodes(asset, highest);
  JointBodies result;
  result.of_joints.reserve(asset.joints.size());
  result.above.reserve(asset.joints.size());
  for (const Joint& joint : asset.joints) {
    result.of_joints.push_back(*bodies[highest[joint.node]]);
    std::uint32_t node = asset.nodes[highest[joint.node]].parent;
    while (node != kNoParent && !bodies[highest[node]]) node = asset.nodes[highest[node]].parent;
    result.above.push_back(node == kNoParent ? kNoJoint : *bodies[highest[node]]);
  }
  return result;
}

}  // namespace pelt::asset

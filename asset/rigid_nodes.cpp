#include "asset/rigid_nodes.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

namespace pelt::asset {
namespace {

using Bodies = std::vector<std::optional<std::uint16_t>>;

/// Exporters write keys for all joints. Those of joints that nobody has moved differ from the
/// default pose by rounding errors and by the tolerance of inverse kinematics: less than half a
/// degree, or 0.4 % of a length or a scale.
constexpr float kStill = 4e-3F;

float largest(std::span<const float> values) {
  float most = 0;
  for (const float value : values) most = std::max(most, std::fabs(value));
  return most;
}

/// Whether all of `sign` * `values` are as in the default pose.
bool are_as(std::span<const float> defaults, std::span<const float> values, float sign,
            float tolerance) {
  for (std::size_t i = 0; i < defaults.size(); ++i)
    if (!(std::fabs(sign * values[i] - defaults[i]) <= tolerance)) return false;
  return true;
}

/// A quaternion and its negative are the same rotation.
bool is_still(Path path, std::span<const float> defaults, std::span<const float> values) {
  if (path == Path::rotation)
    return are_as(defaults, values, 1, kStill) || are_as(defaults, values, -1, kStill);
  return are_as(defaults, values, 1, kStill * largest(defaults));
}

std::span<const float> default_of(const Transform& local, Path path) {
  if (path == Path::rotation) return local.rotation;
  return path == Path::scale ? std::span<const float>(local.scale) : local.translation;
}

/// Precondition: the channel is not of weights.
bool moves(const Channel& channel, const Transform& local) {
  const std::span<const float> defaults = default_of(local, channel.path);
  const std::size_t n = defaults.size();
  const bool has_tangents = channel.interpolation == Interpolation::cubic_spline;
  const std::span<const float> values = channel.values;
  for (std::size_t i = 0; i + n <= values.size(); i += n) {
    const std::span<const float> row = values.subspan(i, n);
    const bool is_tangent = has_tangents && i / n % 3 != 1;
    if (is_tangent ? largest(row) > kStill * largest(defaults)
                   : !is_still(channel.path, defaults, row))
      return true;
  }
  return false;
}

std::vector<bool> moved_nodes(const Asset& asset) {
  std::vector<bool> moved(asset.nodes.size());
  for (const Clip& clip : asset.clips)
    for (const Channel& channel : clip.channels)
      if (channel.path != Path::weights && !moved[channel.node])
        moved[channel.node] = moves(channel, asset.nodes[channel.node].local);
  return moved;
}

/// The body of each node's joints, by the highest node that they never move against.
Bodies bodies_of_nodes(const Asset& asset, const std::vector<std::uint32_t>& highest) {
  Bodies bodies(asset.nodes.size());
  for (std::size_t j = asset.joints.size(); j-- > 0;)
    bodies[highest[asset.joints[j].node]] = static_cast<std::uint16_t>(j);
  return bodies;
}

}  // namespace

std::vector<std::uint32_t> rigid_nodes(const Asset& asset) {
  const std::vector<bool> moved = moved_nodes(asset);
  const bool is_statue = std::find(moved.begin(), moved.end(), true) == moved.end();
  std::vector<std::uint32_t> highest(asset.nodes.size());
  for (std::uint32_t node = 0; node < highest.size(); ++node) {
    const std::uint32_t parent = asset.nodes[node].parent;
    const bool is_own = is_statue || moved[node] || parent == kNoParent;
    highest[node] = is_own ? node : highest[parent];
  }
  return highest;
}

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

#include "scenes/twisted_arm.hpp"

#include "asset/angles.hpp"
#include "base/vec3.hpp"

#include <cmath>
#include <string_view>

namespace pelt::scenes {
namespace {

using detail::Vec3d;

std::uint32_t joint_named(const asset::Asset& creature, std::string_view name) {
  std::uint32_t joint = 0;
  while (creature.joint_name(joint) != name) ++joint;
  return joint;
}

/// At rest, frames of joints have the axes of the world.
Vec3d rest_position(const asset::Joint& joint) {
  const auto& m = joint.inverse_bind.m;
  return {-static_cast<double>(m[12]), -static_cast<double>(m[13]), -static_cast<double>(m[14])};
}

/// Rotation about the axis through `centre` with the unit direction `n`.
Matrix4 turn_about(const Vec3d& centre, const Vec3d& n, double turns) {
  const double c = asset::cosine_of_turns(turns), s = asset::sine_of_turns(turns);
  const Vec3d units[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const auto turned = [&](const Vec3d& v) {
    return c * v + s * cross(n, v) + (1 - c) * dot(n, v) * n;
  };
  Matrix4 matrix;
  const auto store = [&](std::size_t column, const Vec3d& v) {
    const Vec3 rounded = to_float(v);
    matrix.m[4 * column] = rounded.x;
    matrix.m[4 * column + 1] = rounded.y;
    matrix.m[4 * column + 2] = rounded.z;
  };
  for (std::size_t axis = 0; axis < 3; ++axis) store(axis, turned(units[axis]));
  store(3, centre - turned(centre));
  return matrix;
}

bool is_below(const asset::Asset& asset, std::uint32_t node, std::uint32_t ancestor) {
  for (; node != asset::kNoParent; node = asset.nodes[node].parent)
    if (node == ancestor) return true;
  return false;
}

}  // namespace

std::vector<Matrix4> twisted_arm(const asset::Asset& creature, double turns) {
  const asset::Joint& elbow = creature.joints[joint_named(creature, "fore_arm_l")];
  const asset::Joint& wrist = creature.joints[joint_named(creature, "hand_l")];
  const Vec3d along = rest_position(wrist) - rest_position(elbow);
  const Vec3d axis = 1 / std::sqrt(squared_length(along)) * along;
  const Matrix4 turn = turn_about(rest_position(elbow), axis, turns);
  std::vector<Matrix4> palette(creature.joints.size());
  for (std::size_t j = 0; j < palette.size(); ++j)
    if (is_below(creature, creature.joints[j].node, elbow.node)) palette[j] = turn;
  return palette;
}

}  // namespace pelt::scenes

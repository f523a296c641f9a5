#include "scenes/demo.hpp"

#include "asset/transform.hpp"
#include "base/vec3.hpp"

#include <array>
#include <cmath>
#include <string_view>

namespace pelt::scenes {
namespace {

using Ring = std::array<std::uint32_t, 4>;
using detail::Vec3d;

/// Numbers of four vertices around the x axis.
/// Adds vertices in a plane across the x axis: above, in front, below and behind.
Ring add_ring(float x, float height, float depth, asset::Asset& sword) {
  const auto first = static_cast<std::uint32_t>(sword.rest_positions.size());
  for (const Vec3& position :
       {Vec3{x, height, 0}, Vec3{x, 0, depth}, Vec3{x, -height, 0}, Vec3{x, 0, -depth}})
    sword.rest_positions.push_back(position);
  return {first, first + 1, first + 2, first + 3};
}

/// Adds the surface between two rings. `near` has the larger x.
void add_sides(const Ring& near, const Ring& far, asset::Asset& sword) {
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t next = (i + 1) % 4;
    sword.triangles.push_back({near[i], near[next], far[i]});
    sword.triangles.push_back({near[next], far[next], far[i]});
  }
}

void add_tip(const Ring& ring, float x, asset::Asset& sword) {
  const auto tip = static_cast<std::uint32_t>(sword.rest_positions.size());
  sword.rest_positions.push_back({x, 0, 0});
  for (std::size_t i = 0; i < 4; ++i) sword.triangles.push_back({ring[i], ring[(i + 1) % 4], tip});
}

/// Closes the end with the larger x.
void add_near_end(const Ring& ring, asset::Asset& sword) {
  sword.triangles.push_back({ring[0], ring[2], ring[1]});
  sword.triangles.push_back({ring[0], ring[3], ring[2]});
}

void add_far_end(const Ring& ring, asset::Asset& sword) {
  sword.triangles.push_back({ring[0], ring[1], ring[2]});
  sword.triangles.push_back({ring[0], ring[2], ring[3]});
}

/// Adds the grip and the blade, two closed surfaces.
void add_surface(asset::Asset& sword) {
  const Ring pommel = add_ring(0.06f, 0.018f, 0.018f, sword);
  const Ring guard = add_ring(-0.12f, 0.018f, 0.018f, sword);
  add_near_end(pommel, sword);
  add_sides(pommel, guard, sword);
  add_far_end(guard, sword);
  const Ring base = add_ring(-0.13f, 0.004f, 0.025f, sword);
  const Ring shoulder = add_ring(-0.8f, 0.003f, 0.02f, sword);
  add_near_end(base, sword);
  add_sides(base, shoulder, sword);
  add_tip(shoulder, -0.9f, sword);
}

void add_skin(asset::Asset& sword) {
  sword.nodes.resize(2);
  sword.nodes[0].name = "sword";
  sword.nodes[1].name = "grip";
  sword.nodes[1].parent = 0;
  sword.joints.emplace_back();
  sword.joints[0].node = 1;
  sword.influences_per_vertex = 4;
  for (std::size_t v = 0; v < sword.rest_positions.size(); ++v) {
    sword.joint_indices.insert(sword.joint_indices.end(), {0, 0, 0, 0});
    sword.weights.insert(sword.weights.end(), {1, 0, 0, 0});
  }
  const auto count = static_cast<std::uint32_t>(sword.triangles.size());
  sword.parts.push_back({"sword", "blade", "steel", 0, count, true});
}

asset::Clip swing() {
  constexpr float kHalf = 0.70710678f;  // sin and cos of 45 degrees
  asset::Channel turn;
  turn.node = 1;
  turn.path = asset::Path::rotation;
  turn.times = {0, 0.1f, 0.1f + 1.0f / 12, 0.1f + 1.0f / 6, 0.4f};
  for (const float sine : {kHalf, kHalf, 0.0f, -kHalf, -kHalf})
    turn.values.insert(turn.values.end(), {0, sine, 0, sine == 0 ? 1 : kHalf});
  return {"swing", 0.4f, {turn}};
}

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

asset::Asset make_sword() {
  asset::Asset sword;
  add_surface(sword);
  add_skin(sword);
  sword.clips.push_back(swing());
  return sword;
}

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

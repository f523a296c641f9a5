#include "scenes/creature/body.hpp"

#include "base/assert.hpp"
#include "scenes/creature/polygonise.hpp"
#include "scenes/creature/remesh.hpp"
#include "scenes/creature/skin_weights.hpp"

#include <cmath>
#include <string>
#include <utility>

namespace pelt::scenes {
namespace {

/// Joints beyond the first twenty, in the order in which larger skeletons add them. The last is
/// added alone, so that every count is possible.
struct Addition {
  const char* name;
  bool on_both_sides;
};
constexpr Addition kAdditions[] = {
    {"clavicle", true},  {"spine_2", false}, {"jaw", false},      {"tail_4", false},
    {"ear_1", true},     {"thumb_1", true},  {"index_1", true},   {"middle_1", true},
    {"little_1", true},  {"neck_2", false},  {"tail_6", false},   {"tail_2", false},
    {"thumb_2", true},   {"index_2", true},  {"middle_2", true},  {"tail_3", false},
    {"little_2", true},  {"tail_5", false},  {"toe_inner", true}, {"toe_middle", true},
    {"toe_outer", true}, {"ear_2", true},    {"index_3", true},   {"middle_3", true},
    {"little_3", true},  {"tail_7", false},  {"tail_8", false},
};

std::vector<std::uint32_t> joints_of(const Addition& addition, const BodyPlan& plan) {
  const std::string name = addition.name;
  if (!addition.on_both_sides) return {find_joint(plan, name)};
  return {find_joint(plan, name + "_l"), find_joint(plan, name + "_r")};
}

// Fine enough for fingers and, in most cases, the clefts between them.
constexpr double kCoarsestSpacing = 0.016;
constexpr double kTrianglesPerTriangle = 1.6;  // in the polygonised mesh, per final triangle

bool is_like_a_ball(const RawMesh& mesh) {
  return mesh.positions.size() == mesh.triangles.size() / 2 + 2;
}

/// Uses a finer lattice if a coarse one makes bridges across the clefts between fingers.
RawMesh polygonise_without_bridges(const Flesh& flesh, double spacing) {
  RawMesh raw = polygonise(flesh, spacing);
  for (int refinement = 0; refinement < 6 && !is_like_a_ball(raw); ++refinement) {
    spacing *= 0.8;
    raw = polygonise(flesh, spacing);
  }
  PELT_ASSERT(is_like_a_ball(raw));
  return raw;
}

RawMesh make_surface(const Flesh& flesh, std::uint32_t triangle_count) {
  RawMesh raw = polygonise_without_bridges(flesh, kCoarsestSpacing);
  const double wanted = kTrianglesPerTriangle * triangle_count;
  const double available = static_cast<double>(raw.triangles.size());
  if (available < wanted) {
    raw = polygonise_without_bridges(flesh, kCoarsestSpacing * std::sqrt(available / wanted));
  }
  return remesh(flesh, std::move(raw), triangle_count);
}

/// Adds nodes for the kept joints below a root node. Returns the node of each plan joint.
std::vector<std::uint32_t> add_skeleton(const BodyPlan& plan,
                                        std::span<const std::uint32_t> stands_for,
                                        const std::string& name, asset::Asset& asset) {
  std::vector<std::uint32_t> nodes(plan.joints.size(), kNone);
  asset.nodes.emplace_back();
  asset.nodes.front().name = name;
  for (std::uint32_t j = 0; j < plan.joints.size(); ++j) {
    if (stands_for[j] != j) continue;
    const std::uint32_t parent = plan.joints[j].parent;
    const bool is_root = parent == kNone;
    const Vec3d origin = is_root ? Vec3d() : plan.joints[stands_for[parent]].position;
    const Vec3 offset = to_float(plan.joints[j].position - origin);
    nodes[j] = static_cast<std::uint32_t>(asset.nodes.size());
    asset.nodes.emplace_back();
    asset.nodes.back().name = plan.joints[j].name;
    asset.nodes.back().parent = is_root ? 0 : nodes[stands_for[parent]];
    asset.nodes.back().local.translation = {offset.x, offset.y, offset.z};

    const Vec3 place = to_float(plan.joints[j].position);
    asset::Joint joint;
    joint.node = nodes[j];
    joint.inverse_bind.m[12] = -place.x;
    joint.inverse_bind.m[13] = -place.y;
    joint.inverse_bind.m[14] = -place.z;
    asset.joints.push_back(joint);
  }
  return nodes;
}

void add_skin(const BodyPlan& plan, std::span<const std::uint32_t> stands_for,
              const std::vector<std::uint32_t>& nodes, const std::vector<Vec3d>& positions,
              asset::Asset& asset) {
  SkinWeights skin(plan, stands_for);
  asset.influences_per_vertex = kInfluences;
  for (const Vec3d& position : positions) {
    asset.rest_positions.push_back(to_float(position));
    const VertexWeights vertex = skin.at(position);
    for (std::uint32_t k = 0; k < kInfluences; ++k) {
      // Joints are in the order of their nodes, which follow the root node.
      asset.joint_indices.push_back(static_cast<std::uint16_t>(nodes[vertex.joints[k]] - 1));
      asset.weights.push_back(static_cast<float>(vertex.weights[k]));
    }
  }
}

}  // namespace

std::vector<std::uint32_t> choose_joints(const BodyPlan& plan, std::uint32_t count) {
  PELT_ASSERT(count >= kBaseJoints && count <= kPlanJoints);
  std::vector<bool> kept(plan.joints.size(), true);
  std::uint32_t room = count - kBaseJoints;
  for (const Addition& addition : kAdditions) {
    const std::vector<std::uint32_t> joints = joints_of(addition, plan);
    const bool fits = joints.size() <= room;
    if (fits) room -= static_cast<std::uint32_t>(joints.size());
    for (std::uint32_t joint : joints) kept[joint] = fits;
  }
  PELT_ASSERT(room == 0);
  std::vector<std::uint32_t> stands_for(plan.joints.size());
  for (std::uint32_t j = 0; j < plan.joints.size(); ++j) {
    stands_for[j] = kept[j] ? j : stands_for[plan.joints[j].parent];
  }
  return stands_for;
}

Body grow_body(const BodyPlan& plan, std::span<const std::uint32_t> stands_for,
               std::uint32_t triangle_count, const std::string& name) {
  Body body;
  body.nodes = add_skeleton(plan, stands_for, name, body.asset);
  RawMesh surface = make_surface(plan.flesh, triangle_count);
  add_skin(plan, stands_for, body.nodes, surface.positions, body.asset);
  body.asset.triangles = std::move(surface.triangles);
  body.asset.parts.push_back({name, "body", "hide", 0, triangle_count, true});
  body.positions = std::move(surface.positions);
  return body;
}

}  // namespace pelt::scenes

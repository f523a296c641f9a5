#pragma once

/// The body of a creature: its surface, and the joints that it has.

#include <pelt/asset.hpp>

#include "scenes/creature/body_plan.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace pelt::scenes {

inline constexpr std::uint32_t kBaseJoints = 20;

/// A skeleton of `count` joints: for every plan joint, the plan joint that replaces it, which is
/// itself or its nearest kept ancestor. Left and right keep the same joints. Precondition:
/// kBaseJoints <= count <= kPlanJoints.
std::vector<std::uint32_t> choose_joints(const BodyPlan& plan, std::uint32_t count);

/// A character grown from a plan: node 0 has the mesh, and the skeleton is below it.
struct Body {
  asset::Asset asset;                ///< without clips
  std::vector<std::uint32_t> nodes;  ///< of each kept plan joint
  std::vector<Vec3d> positions;      ///< [V] the rest positions before rounding
};

/// Grows one closed surface of exactly `triangle_count` triangles, with the skeleton of
/// `stands_for`, a result of `choose_joints`. Precondition: `triangle_count` is even.
Body grow_body(const BodyPlan& plan, std::span<const std::uint32_t> stands_for,
               std::uint32_t triangle_count, const std::string& name);

}  // namespace pelt::scenes

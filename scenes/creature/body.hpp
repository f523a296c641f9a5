#pragma once

#include <pelt/asset.hpp>

#include "scenes/creature/body_plan.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace pelt::scenes {

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

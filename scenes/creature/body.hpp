#pragma once

#include <pelt/asset.hpp>

#include "scenes/creature/body_plan.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace pelt::scenes {

/// A character grown from a plan: node 0 bears the mesh, and the skeleton stands below it.
struct Body {
  asset::Asset asset;                ///< without clips
  std::vector<std::uint32_t> nodes;  ///< of each plan joint that was kept
  std::vector<Vec3d> positions;      ///< [V] the rest positions before they were rounded
};

/// One closed surface of exactly `triangle_count` triangles, which is even, with the skeleton that
/// `stands_for` tells, as `choose_joints` does.
Body grow_body(const BodyPlan& plan, std::span<const std::uint32_t> stands_for,
               std::uint32_t triangle_count, const std::string& name);

}  // namespace pelt::scenes

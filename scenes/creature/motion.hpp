#pragma once

#include <pelt/asset.hpp>

#include "scenes/creature/body_plan.hpp"

#include <span>

namespace pelt::scenes {

/// The clips for a skeleton of `choose_joints`. `nodes` has the node of each kept plan joint; its
/// parent is the node of the nearest kept ancestor.
asset::Clip walk_clip(const BodyPlan& plan, std::span<const std::uint32_t> stands_for,
                      std::span<const std::uint32_t> nodes);
asset::Clip idle_clip(const BodyPlan& plan, std::span<const std::uint32_t> stands_for,
                      std::span<const std::uint32_t> nodes);

}  // namespace pelt::scenes

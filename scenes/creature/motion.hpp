#pragma once

#include <pelt/asset.hpp>

#include "scenes/creature/body_plan.hpp"

#include <span>

namespace pelt::scenes {

/// The clips, for a skeleton as `choose_joints` returns it. `nodes` gives the node of each plan
/// joint that was kept; the parent of its node is that of its nearest kept ancestor.
asset::Clip walk_clip(const BodyPlan& plan, std::span<const std::uint32_t> stands_for,
                      std::span<const std::uint32_t> nodes);
asset::Clip idle_clip(const BodyPlan& plan, std::span<const std::uint32_t> stands_for,
                      std::span<const std::uint32_t> nodes);

}  // namespace pelt::scenes

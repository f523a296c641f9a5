#pragma once

#include <pelt/asset.hpp>

#include "scenes/creature/body_plan.hpp"

#include <cstdint>
#include <span>

namespace pelt::scenes {

/// The clip "talk" of a bust whose plan joints have these nodes, kNone for omitted joints. Node 0
/// has the morph targets.
asset::Clip talk_clip(const BodyPlan& bust, std::span<const std::uint32_t> nodes);

}  // namespace pelt::scenes

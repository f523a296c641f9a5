#pragma once

#include "scenes/creature/body_plan.hpp"

#include <cstdint>
#include <vector>

namespace pelt::scenes {

inline constexpr std::uint32_t kBaseJoints = 20;

/// A skeleton of `count` joints: for every plan joint, the plan joint that replaces it, which is
/// itself or its nearest kept ancestor. Left and right keep the same joints. Precondition:
/// kBaseJoints <= count <= kPlanJoints.
std::vector<std::uint32_t> choose_joints(const BodyPlan& plan, std::uint32_t count);

}  // namespace pelt::scenes

#pragma once

#include "asset/quaternion.hpp"
#include "scenes/creature/body_plan.hpp"

#include <array>
#include <vector>

namespace pelt::scenes {

using asset::Quaternion;

/// Where a foot goes: it is turned about the x axis by `pitch` turns (toes down) about its heel or
/// ball, whichever is then lower, and shifted by `offset` from its place at rest. The toes bend
/// back by `toe_bend` turns.
struct FootTarget {
  Vec3d offset;
  double pitch = 0;
  double toe_bend = 0;
};

/// One pose of the whole plan.
struct Posture {
  std::vector<Quaternion> local;  ///< [plan joints] relative to the parent
  Vec3d hips_offset;              ///< from the place at rest
};

/// Sets the rotations of the legs so that the feet (left, right) meet their targets, knees
/// forwards; out of reach, the leg is stretched towards them. The hips' rotation and offset are
/// taken as they are.
void place_feet(const BodyPlan& plan, const std::array<FootTarget, 2>& targets, Posture& posture);

}  // namespace pelt::scenes

#pragma once

#include "asset/transform.hpp"
#include "scenes/creature/body_plan.hpp"

#include <array>
#include <vector>

namespace pelt::scenes {

using asset::Quaternion;

/// Target of a foot. The foot is rotated about the x axis by `pitch` turns (toes down), about its
/// heel or ball, whichever is then lower, and translated by `offset` from its rest position. The
/// toes bend back by `toe_bend` turns.
struct FootTarget {
  Vec3d offset;
  double pitch = 0;
  double toe_bend = 0;
};

/// One pose of the whole plan.
struct Posture {
  std::vector<Quaternion> local;  ///< [plan joints] relative to the parent
  Vec3d hips_offset;              ///< from the rest position
};

/// Sets the rotations of the legs so that the feet (left, right) reach their targets, knees
/// forwards. If a target is out of reach, the leg is stretched towards it. Uses the current
/// rotation and offset of the hips.
void place_feet(const BodyPlan& plan, const std::array<FootTarget, 2>& targets, Posture& posture);

}  // namespace pelt::scenes

#pragma once

#include <pelt/asset.hpp>

#include <vector>

namespace pelt::scenes {

/// Returns the palette of a creature in its rest pose, with the left forearm and the hand turned
/// about the axis of the forearm by this fraction of a turn. Precondition: `creature` is the result
/// of make_creature.
std::vector<Matrix4> twisted_arm(const asset::Asset& creature, double turns);

}  // namespace pelt::scenes

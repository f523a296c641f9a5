#pragma once

#include "scenes/scene.hpp"

namespace pelt::reproduce {

/// Two instances who walk on the spot, each in a phase of its own, face each other and stand so far
/// apart, from middle to middle. Each frame is one of so many phases, evenly over the walk.
scenes::Scene facing_pair(const scenes::Character& character, double distance,
                          std::uint32_t phases = 1);

/// The same while they come nearer from frame to frame.
scenes::Scene closing_pair(const scenes::Character& character, double from, double to,
                           std::uint32_t frames);

}  // namespace pelt::reproduce

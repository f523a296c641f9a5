#pragma once

#include "scenes/scene.hpp"

namespace pelt::reproduce {

/// Two instances that walk on the spot in different phases and face each other, `distance` apart
/// from middle to middle. The frames are phases at even intervals of the walk.
scenes::Scene facing_pair(const scenes::Character& character, double distance,
                          std::uint32_t phases = 1);

/// The same, with the distance shrinking from frame to frame.
scenes::Scene closing_pair(const scenes::Character& character, double from, double to,
                           std::uint32_t frames);

}  // namespace pelt::reproduce

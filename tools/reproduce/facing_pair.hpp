#pragma once

#include "scenes/scene.hpp"

namespace pelt::reproduce {

/// One frame of two instances who walk, each in a phase of its own, face each other and stand so
/// far apart, from middle to middle.
scenes::Scene facing_pair(const scenes::Character& character, double distance);

}  // namespace pelt::reproduce

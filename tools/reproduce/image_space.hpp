#pragma once

#include "scenes/scene.hpp"
#include "tools/reproduce/experiment.hpp"

namespace pelt::reproduce {

/// Layered depth images asked whether two characters touch, at many distances, beside the exact
/// answer: how often they are wrong at which resolution, and what that takes.
Result<Table> image_space_table(const scenes::Character& character, const Conditions& conditions);

}  // namespace pelt::reproduce

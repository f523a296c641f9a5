#pragma once

#include "evaluation/reproduce/experiment.hpp"
#include "scenes/scene.hpp"

namespace pelt::reproduce {

/// Layered depth images, which only answer whether two bodies touch, beside exact methods:
/// "image_space" by resolution, with charts of time and misses, and "image_space_rivals".
Result<void> add_image_space(const scenes::Character& character, const Conditions& conditions,
                             Section& section);

}  // namespace pelt::reproduce

#pragma once

#include <pelt/surface.hpp>

#include "tools/pelt/scene/staged_scene.hpp"

#include <span>
#include <vector>

namespace pelt::tools::check {

/// The surface of each collider; colliders of one model share it.
std::vector<Surface> make_surfaces(const scene::StagedScene& staged);

}  // namespace pelt::tools::check

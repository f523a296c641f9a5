#pragma once

#include <pelt/contact.hpp>

#include "tools/pelt/scene/colliders.hpp"

#include <span>
#include <vector>

namespace pelt::tools::check {

/// The surface of each collider; those of one model share theirs.
std::vector<Surface> make_surfaces(const scenes::Scene& scene,
                                   std::span<const scene::Collider> colliders);

}  // namespace pelt::tools::check

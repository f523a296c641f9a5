#pragma once

#include <pelt/surface.hpp>

#include "tools/pelt/scene/staged_scene.hpp"

#include <nlohmann/json_fwd.hpp>

namespace pelt::tools::check {

/// Returns the geometry of the contacts of two colliders, given by their numbers, with names of
/// parts and joints: `traces`, `curves` and `patches` as in the manual page.
nlohmann::ordered_json contact_geometry_json(const scene::StagedScene& staged, std::uint32_t a,
                                             std::uint32_t b, const ContactGeometry& geometry);

}  // namespace pelt::tools::check

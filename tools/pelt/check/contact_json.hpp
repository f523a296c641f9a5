#pragma once

#include <pelt/contact.hpp>

#include "scenes/scene.hpp"
#include "tools/pelt/scene/colliders.hpp"

#include <nlohmann/json_fwd.hpp>

namespace pelt::tools::check {

/// The geometry of two colliders' contacts, with names of parts and joints: `traces`, `curves` and
/// `regions` as the manual page has them.
nlohmann::ordered_json contact_geometry_json(const scenes::Scene& scene, const scene::Collider& a,
                                             const scene::Collider& b,
                                             const ContactGeometry& geometry);

}  // namespace pelt::tools::check

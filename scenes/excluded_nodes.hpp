#pragma once

/// Nodes of several models to leave out, by names that one of the models has to have: "Cape" is the
/// name of a node of any model, "knight/Cape" of that model alone.

#include <pelt/asset.hpp>
#include <pelt/result.hpp>

#include "scenes/scene.hpp"

#include <string>

namespace pelt::scenes {

/// What is left out of one of the models.
asset::GltfOptions options_for(const std::string& model, const asset::GltfOptions& options);

/// Refuses a name to exclude that no node of the scene's files has. O(names times nodes).
Result<void> check_excluded(const Scene& scene, const asset::GltfOptions& options);

}  // namespace pelt::scenes

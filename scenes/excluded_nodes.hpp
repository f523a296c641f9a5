#pragma once

/// Names of nodes of several models to leave out. At least one of the models must have each name.
/// "Cape" matches nodes of any model, "knight/Cape" only nodes of one model.

#include <pelt/asset.hpp>
#include <pelt/result.hpp>

#include "scenes/scene.hpp"

#include <string>

namespace pelt::scenes {

/// Returns the options for one of the models.
asset::GltfOptions options_for(const std::string& model, const asset::GltfOptions& options);

/// Returns an error for a name to exclude that no node of the scene's files has. O(names times
/// nodes).
Result<void> check_excluded(const Scene& scene, const asset::GltfOptions& options);

}  // namespace pelt::scenes

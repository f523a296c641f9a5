#pragma once

#include <pelt/asset.hpp>

#include "skin/skinned_mesh.hpp"

namespace pelt::scenes {

/// Returns the validated mesh of an asset without morph targets, with weights that sum to 1.
Result<detail::SkinnedMesh> mesh_without_morphs(const asset::Asset& asset);

}  // namespace pelt::scenes

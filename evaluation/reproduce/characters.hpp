#pragma once

/// Characters in the forms that experiments need.

#include <pelt/asset.hpp>
#include <pelt/model.hpp>

#include "scenes/creature.hpp"
#include "skin/palette.hpp"
#include "skin/skinned_mesh.hpp"

#include <filesystem>
#include <vector>

namespace pelt::reproduce {

struct Specimen {
  asset::Asset asset;
  SkinnedModel model;
  detail::SkinnedMesh mesh;
};

Result<Specimen> make_specimen(asset::Asset asset);
Result<Specimen> make_specimen(const scenes::CreatureOptions& options);

/// The palette of the clip "walk" at a time.
detail::Palette walking_palette(const Specimen& specimen, float seconds);

/// The .glb files of a folder, sorted by name; empty if the folder does not exist.
std::vector<std::filesystem::path> model_files(const std::filesystem::path& folder);

}  // namespace pelt::reproduce

#pragma once

/// A character in the forms that experiments need.

#include <pelt/asset.hpp>
#include <pelt/model.hpp>

#include "scenes/creature.hpp"
#include "skin/palette.hpp"
#include "skin/skinned_mesh.hpp"

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

}  // namespace pelt::reproduce

#pragma once

/// A scene and the colliders made from its instances.

#include "scenes/scene.hpp"
#include "tools/pelt/scene/colliders.hpp"

#include <span>

namespace pelt::tools::scene {

/// Borrows both: they must outlive it.
struct StagedScene {
  const scenes::Scene& scene;
  std::span<const Collider> colliders;

  std::uint32_t character_of(std::uint32_t collider) const {
    return scene.instances[colliders[collider].instance].character;
  }
  const asset::Asset& asset_of(std::uint32_t collider) const {
    return scene.characters[character_of(collider)].asset;
  }
};

}  // namespace pelt::tools::scene

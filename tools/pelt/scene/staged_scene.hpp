#pragma once

/// A scene and the colliders made from its instances, with their names.

#include "scenes/scene.hpp"
#include "tools/pelt/scene/colliders.hpp"
#include "tools/pelt/scene/scene_names.hpp"

#include <memory>
#include <span>
#include <string>

namespace pelt::tools::scene {

/// Borrows scene and colliders, which must outlive it. Copies share the names.
struct StagedScene {
  StagedScene(const scenes::Scene& of, std::span<const Collider> made)
      : scene(of), colliders(made), names(std::make_shared<const SceneNames>(of)) {}

  std::uint32_t character_of(std::uint32_t collider) const {
    return scene.instances[colliders[collider].instance].character;
  }
  const asset::Asset& asset_of(std::uint32_t collider) const {
    return scene.characters[character_of(collider)].asset;
  }

  const scenes::Scene& scene;
  std::span<const Collider> colliders;
  std::shared_ptr<const SceneNames> names;
};

/// Returns "knight 0", or "knight 0 Knight_Helmet" for a part; printable.
std::string collider_name(const StagedScene& staged, const Collider& collider);

}  // namespace pelt::tools::scene

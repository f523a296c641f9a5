#pragma once

/// A scene and the colliders made from its instances, with their names.

#include <pelt/distance.hpp>

#include "scenes/scene.hpp"
#include "tools/pelt/scene/colliders.hpp"

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace pelt::tools::scene {

class SceneNames {
 public:
  /// Copies what it needs. Cost: O(parts and instances).
  explicit SceneNames(const scenes::Scene& scene);

  const std::string& part(std::uint32_t character, std::uint32_t part) const {
    return parts_[character][part];
  }

  /// Number of earlier instances whose model has the same name.
  std::uint32_t copy(std::uint32_t instance) const { return copies_[instance]; }

 private:
  std::vector<std::vector<std::string>> parts_;  // [characters][parts]
  std::vector<std::uint32_t> copies_;            // [instances]
};

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

/// Description of a point of a collider's surface.
struct NamedPoint {
  std::uint32_t triangle = 0;  ///< its number in the whole model
  std::string part, joint;
};

NamedPoint name_point(const StagedScene& staged, const Collider& collider,
                      const SurfacePoint& point);

/// "knight 0 Knight_Helmet (head, triangle 12)"
std::string place_words(const StagedScene& staged, const Collider& collider,
                        const SurfacePoint& point);

}  // namespace pelt::tools::scene

#pragma once

/// Names of parts and instances, computed once for a scene.

#include "scenes/scene.hpp"

#include <cstdint>
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

}  // namespace pelt::tools::scene

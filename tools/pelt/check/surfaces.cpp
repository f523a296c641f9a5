#include "tools/pelt/check/surfaces.hpp"

#include <map>
#include <utility>

namespace pelt::tools::check {

std::vector<Surface> make_surfaces(const scene::StagedScene& staged) {
  std::map<std::pair<std::uint32_t, std::optional<std::uint32_t>>, Surface> by_model;
  std::vector<Surface> surfaces;
  for (const scene::Collider& collider : staged.colliders) {
    const std::uint32_t character = staged.scene.instances[collider.instance].character;
    const auto key = std::make_pair(character, collider.part);
    surfaces.push_back(by_model.try_emplace(key, collider.model).first->second);
  }
  return surfaces;
}

}  // namespace pelt::tools::check

#include "tools/pelt/scene/staged_scene.hpp"

#include "text/printable.hpp"

namespace pelt::tools::scene {

std::string collider_name(const StagedScene& staged, const Collider& collider) {
  const std::uint32_t character = staged.scene.instances[collider.instance].character;
  const std::string name = text::printable_name(staged.scene.characters[character].name) + " " +
                           std::to_string(collider.instance);
  if (!collider.part) return name;
  return name + " " + text::printable_name(staged.names->part(character, *collider.part));
}

}  // namespace pelt::tools::scene

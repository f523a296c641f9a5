#include "tools/pelt/scene/scene_names.hpp"

#include "scenes/names.hpp"

#include <string_view>
#include <unordered_map>

namespace pelt::tools::scene {

SceneNames::SceneNames(const scenes::Scene& scene) {
  for (const scenes::Character& character : scene.characters)
    parts_.push_back(scenes::part_names(character.asset));
  std::unordered_map<std::string_view, std::uint32_t> copies;
  for (const scenes::Instance& instance : scene.instances)
    copies_.push_back(copies[scene.characters[instance.character].name]++);
}

}  // namespace pelt::tools::scene

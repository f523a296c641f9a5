#include "tools/pelt/touch_name.hpp"

#include "scenes/names.hpp"

#include <nlohmann/json.hpp>

namespace pelt::tools {
namespace {

nlohmann::ordered_json name_json(const TouchName& name) {
  return {{"instance", name.instance},
          {"model", name.model},
          {"part", name.part},
          {"joint", name.joint}};
}

}  // namespace

TouchName touch_name(const scenes::Scene& scene, const TouchPlace& place) {
  const scenes::Character& character = scene.characters[scene.instances[place.instance].character];
  return {place.instance, character.name, scenes::part_name(character.asset, place.part),
          scenes::joint_name(character.asset, place.joint)};
}

std::string in_words(const TouchName& name) {
  return name.model + " " + std::to_string(name.instance) + " " + name.part + " " + name.joint;
}

nlohmann::ordered_json touch_json(const scenes::Scene& scene, const Touch& touch) {
  return {{"a", name_json(touch_name(scene, touch.a))},
          {"b", name_json(touch_name(scene, touch.b))},
          {"contacts", touch.contacts},
          {"frames", touch.frames},
          {"worst", {{"frame", touch.worst_frame}, {"contacts", touch.worst}}}};
}

}  // namespace pelt::tools

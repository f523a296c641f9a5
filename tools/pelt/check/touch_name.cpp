#include "tools/pelt/check/touch_name.hpp"

#include "asset/printable.hpp"
#include "scenes/names.hpp"
#include "tools/pelt/scene/json_lines.hpp"

#include <nlohmann/json.hpp>

namespace pelt::tools::check {
namespace {

using nlohmann::ordered_json;

const scenes::Character& character_of(const scenes::Scene& scene, std::uint32_t instance) {
  return scene.characters[scene.instances[instance].character];
}

BodyName instance_name(const scenes::Scene& scene, std::uint32_t instance) {
  const std::string& model = character_of(scene, instance).name;
  BodyName name;
  name.model = scene::as_json_holds(model);
  for (std::uint32_t i = 0; i < instance; ++i) name.copy += character_of(scene, i).name == model;
  return name;
}

ordered_json with_instance(std::uint32_t instance, const ordered_json& name) {
  ordered_json place = {{"instance", instance}};
  place.update(name);
  return place;
}

}  // namespace

BodyName body_name(const scenes::Scene& scene, const scene::Collider& collider) {
  BodyName name = instance_name(scene, collider.instance);
  const asset::Asset& asset = character_of(scene, collider.instance).asset;
  if (collider.part) name.part = scene::as_json_holds(scenes::part_name(asset, *collider.part));
  return name;
}

TouchName touch_name(const scenes::Scene& scene, const TouchPlace& place) {
  const asset::Asset& asset = character_of(scene, place.instance).asset;
  TouchName name = {instance_name(scene, place.instance),
                    scene::as_json_holds(scenes::joint_name(asset, place.joint))};
  name.body.part = scene::as_json_holds(scenes::part_name(asset, place.part));
  return name;
}

std::string in_words(const scenes::Scene& scene, const TouchPlace& place) {
  const scenes::Character& character = character_of(scene, place.instance);
  return asset::printable_name(character.name) + " " + std::to_string(place.instance) + " " +
         asset::printable_name(scenes::part_name(character.asset, place.part)) + " " +
         asset::printable_name(scenes::joint_name(character.asset, place.joint));
}

ordered_json touch_json(const scenes::Scene& scene, const Touch& touch) {
  return {{"a", with_instance(touch.a.instance, name_json(touch_name(scene, touch.a)))},
          {"b", with_instance(touch.b.instance, name_json(touch_name(scene, touch.b)))},
          {"contacts", touch.contacts},
          {"frames", touch.frames},
          {"worst", {{"frame", touch.worst_frame}, {"contacts", touch.worst}}}};
}

ordered_json held_json(const scene::StagedScene& staged, const Held& held) {
  const auto body = [&](std::uint32_t collider) {
    return with_instance(staged.colliders[collider].instance,
                         name_json(body_name(staged.scene, staged.colliders[collider])));
  };
  return {{"inner", body(held.inner)},
          {"outer", body(held.outer)},
          {"frames", held.frames},
          {"first_frame", held.first_frame}};
}

ordered_json name_json(const BodyName& name) {
  ordered_json body = {{"model", name.model}, {"copy", name.copy}};
  if (!name.part.empty()) body["part"] = name.part;
  return body;
}

ordered_json name_json(const TouchName& name) {
  ordered_json place = name_json(name.body);
  place["joint"] = name.joint;
  return place;
}

}  // namespace pelt::tools::check

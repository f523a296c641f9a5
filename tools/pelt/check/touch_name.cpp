#include "tools/pelt/check/touch_name.hpp"

#include "asset/printable.hpp"
#include "scenes/names.hpp"
#include "tools/pelt/scene/json_lines.hpp"

#include <nlohmann/json.hpp>

namespace pelt::tools::check {
namespace {

using nlohmann::ordered_json;

BodyName instance_name(const scene::StagedScene& staged, std::uint32_t instance) {
  const std::uint32_t character = staged.scene.instances[instance].character;
  return {scene::as_json_holds(staged.scene.characters[character].name),
          staged.names->copy(instance), ""};
}

const std::string& part_name(const scene::StagedScene& staged, std::uint32_t instance,
                             std::uint32_t part) {
  return staged.names->part(staged.scene.instances[instance].character, part);
}

std::string joint_name(const scene::StagedScene& staged, const TouchPlace& place) {
  const std::uint32_t character = staged.scene.instances[place.instance].character;
  return scenes::joint_name(staged.scene.characters[character].asset, place.joint);
}

/// "Cape Spine"
std::string words_in_instance(const scene::StagedScene& staged, const TouchPlace& place) {
  return asset::printable_name(part_name(staged, place.instance, place.part)) + " " +
         asset::printable_name(joint_name(staged, place));
}

ordered_json with_instance(std::uint32_t instance, const ordered_json& name) {
  ordered_json place = {{"instance", instance}};
  place.update(name);
  return place;
}

}  // namespace

std::optional<std::string> clip_name(const scenes::Scene& scene, std::uint32_t take) {
  if (scene.takes.empty()) return std::nullopt;
  return scene::as_json_holds(scene.takes[take].clip);
}

BodyName body_name(const scene::StagedScene& staged, const scene::Collider& collider) {
  BodyName name = instance_name(staged, collider.instance);
  if (collider.part)
    name.part = scene::as_json_holds(part_name(staged, collider.instance, *collider.part));
  return name;
}

TouchName touch_name(const scene::StagedScene& staged, const TouchPlace& place) {
  TouchName name = {instance_name(staged, place.instance),
                    scene::as_json_holds(joint_name(staged, place))};
  name.body.part = scene::as_json_holds(part_name(staged, place.instance, place.part));
  return name;
}

std::string instance_words(const scene::StagedScene& staged, std::uint32_t instance) {
  const std::uint32_t character = staged.scene.instances[instance].character;
  return asset::printable_name(staged.scene.characters[character].name) + " " +
         std::to_string(instance);
}

bool is_of_itself(const scene::StagedScene& staged, std::uint32_t a, std::uint32_t b) {
  return a == b && !staged.colliders[0].part;
}

std::string in_words(const scene::StagedScene& staged, const TouchPlace& place) {
  return instance_words(staged, place.instance) + " " + words_in_instance(staged, place);
}

std::string touch_words(const scene::StagedScene& staged, const Touch& touch) {
  const bool is_itself = is_of_itself(staged, touch.a.instance, touch.b.instance);
  return in_words(staged, touch.a) + "  " +
         (is_itself ? kItself + words_in_instance(staged, touch.b) : in_words(staged, touch.b));
}

ordered_json touch_json(const scene::StagedScene& staged, const Touch& touch) {
  ordered_json json = of_clip(clip_name(staged.scene, touch.take));
  json.update(
      ordered_json{{"a", with_instance(touch.a.instance, name_json(touch_name(staged, touch.a)))},
                   {"b", with_instance(touch.b.instance, name_json(touch_name(staged, touch.b)))},
                   {"contacts", touch.contacts},
                   {"frames", touch.frames},
                   {"worst", scene::worst_json(staged.scene, touch.worst_frame, touch.worst)}});
  return json;
}

ordered_json held_json(const scene::StagedScene& staged, const Held& held) {
  const auto body = [&](std::uint32_t collider) {
    return with_instance(staged.colliders[collider].instance,
                         name_json(body_name(staged, staged.colliders[collider])));
  };
  ordered_json json = of_clip(clip_name(staged.scene, held.take));
  json.update(ordered_json{
      {"inner", body(held.inner)}, {"outer", body(held.outer)}, {"frames", held.frames}});
  scene::add_frame(staged.scene, held.first_frame, "first_frame", "first_clip_frame", json);
  return json;
}

ordered_json of_clip(const std::optional<std::string>& clip) {
  ordered_json json = ordered_json::object();
  if (clip) json["clip"] = *clip;
  return json;
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

#include "scenes/scene_text.hpp"

#include "base/assert.hpp"
#include "text/printable.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace pelt::scenes {
namespace {

using nlohmann::ordered_json;

/// Makes the names of models unique, because they are keys.
std::vector<std::string> distinct_names(const Scene& scene) {
  std::vector<std::string> names;
  for (const Character& character : scene.characters) {
    const std::string first = text::as_utf8(character.name);
    std::string name = first;
    for (int i = 2; std::find(names.begin(), names.end(), name) != names.end(); ++i)
      name = first + " " + std::to_string(i);
    names.push_back(name);
  }
  return names;
}

ordered_json source_json(const Character& character, const std::string& path) {
  if (const auto* creature = std::get_if<CreatureOptions>(&character.origin)) {
    return {{"creature",
             {{"triangles", creature->triangles},
              {"joints", creature->joints},
              {"seed", creature->seed}}}};
  }
  if (const auto* face = std::get_if<FaceOptions>(&character.origin))
    return {{"face", {{"triangles", face->triangles}, {"seed", face->seed}}}};
  return path;
}

ordered_json model_json(const Character& character, const std::string& path) {
  ordered_json json = source_json(character, path);
  if (!character.skinning) return json;
  if (json.is_string()) json = {{"file", path}};
  json["skinning"] = name_of(*character.skinning);
  return json;
}

ordered_json morph_weights_json(std::span<const MorphWeight> weights) {
  const auto* by_index = std::get_if<std::uint32_t>(&weights[0].target);
  ordered_json json = by_index ? ordered_json::array() : ordered_json::object();
  for (const MorphWeight& weight : weights) {
    if (by_index) {
      json.push_back(weight.weight);
    } else {
      json[std::get<std::string>(weight.target)] = weight.weight;
    }
  }
  return json;
}

ordered_json instance_json(const Instance& instance, const std::string& model) {
  ordered_json json = {{"model", model},
                       {"clip", nullptr},
                       {"start", instance.start},
                       {"speed", instance.speed},
                       {"translation", instance.translation},
                       {"rotation", instance.rotation},
                       {"scale", instance.scale},
                       {"velocity", instance.velocity}};
  if (instance.clip) json["clip"] = *instance.clip;
  if (!instance.morph_weights.empty())
    json["morph_weights"] = morph_weights_json(instance.morph_weights);
  return json;
}

/// Adds the choices that are set.
void add_self(const SelfOptions& self, ordered_json& file) {
  const auto kept_or_dropped = [](bool drops) { return drops ? "drop" : "keep"; };
  if (self.wanted == SelfContacts::only)
    file["self"] = "only";
  else if (self.wanted)
    file["self"] = self.wanted == SelfContacts::beside;
  if (self.rings) file["self_rings"] = *self.rings;
  if (self.drops_at_rest) file["self_at_rest"] = kept_or_dropped(*self.drops_at_rest);
  if (self.always && *self.always > 0) file["self_always"] = *self.always;
  if (self.always && *self.always <= 0) file["self_always"] = "keep";
  if (self.drops_near_joints) file["self_near_joints"] = kept_or_dropped(*self.drops_near_joints);
}

}  // namespace

std::string scene_text(const Scene& scene, std::span<const std::string> paths) {
  PELT_ASSERT(paths.size() == scene.characters.size());
  const std::vector<std::string> names = distinct_names(scene);
  ordered_json models = ordered_json::object(), instances = ordered_json::array();
  for (std::size_t c = 0; c < names.size(); ++c)
    models[names[c]] = model_json(scene.characters[c], paths[c]);
  for (const Instance& instance : scene.instances)
    instances.push_back(instance_json(instance, names[instance.character]));
  ordered_json frames = {{"count", scene.frame_count}, {"fps", scene.fps}};
  if (!scene.takes.empty()) frames.erase("count");  // the clips determine it
  ordered_json file = {{"models", std::move(models)},
                       {"frames", std::move(frames)},
                       {"instances", std::move(instances)}};
  for (const NamePair& pair : scene.ignore) file["ignore"].push_back({pair.a, pair.b});
  add_self(scene.self, file);
  return file.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace pelt::scenes

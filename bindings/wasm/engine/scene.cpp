/// Reads scene files like the command.

#include "bindings/wasm/engine/export.hpp"
#include "bindings/wasm/engine/handles.hpp"
#include "bindings/wasm/engine/options.hpp"
#include "scenes/clip_samples.hpp"
#include "scenes/demo.hpp"
#include "scenes/ignored_pairs.hpp"
#include "text/message.hpp"

namespace pelt::wasm {
namespace {

using nlohmann::json;

/// Uses indices or names of targets, like the scene file.
json describe(const std::vector<scenes::MorphWeight>& weights) {
  json described = json::object();
  for (const scenes::MorphWeight& morph : weights) {
    const auto* number = std::get_if<std::uint32_t>(&morph.target);
    const auto* name = std::get_if<std::string>(&morph.target);
    described[name != nullptr ? *name : std::to_string(*number)] = morph.weight;
  }
  return described;
}

json describe(const scenes::Instance& instance) {
  return {{"character", instance.character},
          {"clip", instance.clip ? json(*instance.clip) : json(nullptr)},
          {"start", instance.start},
          {"speed", instance.speed},
          {"translation", instance.translation},
          {"rotation", instance.rotation},
          {"scale", instance.scale},
          {"velocity", instance.velocity},
          {"morphWeights", describe(instance.morph_weights)}};
}

/// Returns an error for a name that matches nothing, unless it may match something left out.
Result<void> check_ignored(const scenes::Scene& scene, const asset::GltfOptions& options) {
  if (!options.unskinned_parts || !options.exclude_nodes.empty()) return {};
  const auto known = scenes::check_names(scenes::characters_of(scene), scene.ignore);
  return known ? known : text::prefixed(scene.name + ": ignore", known.error());
}

/// Returns an error if an instance plays all clips, because frames of this scene have no takes.
Result<void> check_clips(const scenes::Scene& scene) {
  if (scene.takes.empty()) return {};
  return text::unsupported(scene.name +
                           ": only the command can play all clips with \"*\": name one clip");
}

Result<std::vector<CharacterHandle>> prepare_all(scenes::Scene& scene, const Options& options) {
  std::vector<CharacterHandle> handles;
  for (std::uint32_t c = 0; c < scene.characters.size(); ++c) {
    Preparation preparation = options.preparation();
    preparation.clips = scenes::played_clips(scene, c);
    Result<CharacterHandle> handle = prepare(std::move(scene.characters[c]), preparation);
    if (!handle) return handle.error();
    handles.push_back(std::move(*handle));
  }
  return handles;
}

/// Describes only the choices that the scene file makes.
json describe(const scenes::SelfOptions& self) {
  constexpr const char* kWanted[] = {"off", "also", "only"};
  json described = json::object();
  if (self.wanted) described["wanted"] = kWanted[static_cast<std::size_t>(*self.wanted)];
  if (self.rings) described["rings"] = *self.rings;
  if (self.drops_at_rest) described["dropsAtRest"] = *self.drops_at_rest;
  if (self.always) described["always"] = *self.always > 0 ? json(*self.always) : json(nullptr);
  if (self.drops_near_joints) described["dropsNearJoints"] = *self.drops_near_joints;
  return described;
}

json describe(const scenes::Scene& scene, std::vector<CharacterHandle> characters) {
  json handles = json::array(), instances = json::array(), ignore = json::array();
  for (CharacterHandle& character : characters)
    handles.push_back(number_for_javascript(new CharacterHandle(std::move(character))));
  for (const scenes::Instance& instance : scene.instances) instances.push_back(describe(instance));
  for (const scenes::NamePair& pair : scene.ignore) ignore.push_back({pair.a, pair.b});
  return {{"name", scene.name},
          {"characters", std::move(handles)},
          {"instances", std::move(instances)},
          {"frameCount", scene.frame_count},
          {"fps", scene.fps},
          {"ignore", std::move(ignore)},
          {"self", describe(scene.self)}};
}

}  // namespace

/// Returns the scene as JSON with handles of its characters.
Result<const char*> read_scene(std::string_view path, std::string_view json) {
  const Result<Options> options = Options::read(json);
  if (!options) return options.error();
  Result<scenes::Scene> scene = scenes::load_scene(std::string(path), options->gltf());
  if (!scene) return scene.error();
  if (const auto checked = check_ignored(*scene, options->gltf()); !checked) return checked.error();
  if (const auto checked = check_clips(*scene); !checked) return checked.error();
  Result<std::vector<CharacterHandle>> characters = prepare_all(*scene, *options);
  if (!characters) return characters.error();
  return answer_json(describe(*scene, std::move(*characters)));
}
PELT_EXPORT(read_scene)

const char* demo_scene() { return answer_text(std::string(scenes::kDemoScene)); }
PELT_EXPORT(demo_scene)

}  // namespace pelt::wasm

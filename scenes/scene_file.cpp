#include "scenes/scene_file.hpp"

#include "asset/parsed_json.hpp"
#include "scenes/strict_object.hpp"
#include "scenes/takes.hpp"
#include "text/message.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pelt::scenes {
namespace {

using nlohmann::json;
using Problem = StrictObject::Problem;

/// Far beyond any use, but small enough to keep arithmetic finite.
constexpr double kMaxNumber = 1e12;
constexpr Range kAnyNumber = {-kMaxNumber, kMaxNumber};
constexpr Range kAnyCount = {0, std::numeric_limits<std::uint32_t>::max()};

CreatureOptions read_creature(const StrictObject& object) {
  const CreatureOptions defaults;
  return {object.count("triangles", defaults.triangles, kAnyCount),
          object.count("joints", defaults.joints, kAnyCount),
          object.count("seed", defaults.seed, kAnyCount)};
}

FaceOptions read_face(const StrictObject& object) {
  const FaceOptions defaults;
  return {object.count("triangles", defaults.triangles, kAnyCount),
          object.count("seed", defaults.seed, kAnyCount)};
}

/// Reads what an object names: a file, a creature or a face.
std::variant<std::string, CreatureOptions, FaceOptions> read_source(const StrictObject& object) {
  if (object.has("file")) {
    for (const char* other : {"creature", "face"})
      if (object.has(other)) object.refuse(other, "a model is a file or generated, not both");
    return object.text("file").value_or("");
  }
  if (object.has("face") && !object.has("creature"))
    return read_face(object.object("face", kFaceKeys));
  object.require("creature");
  if (object.has("face")) object.refuse("face", "a model is a creature or a face, not both");
  return read_creature(object.object("creature", kCreatureKeys));
}

std::optional<Skinning> read_skinning(const StrictObject& object) {
  constexpr std::string_view kKey = "skinning";
  const json* value = object.find(kKey);
  if (value == nullptr) return std::nullopt;
  if (*value == "linear") return Skinning::linear;
  if (*value == "dual-quaternion") return Skinning::dual_quaternion;
  const std::string found =
      value->is_string() ? text::quoted(value->get<std::string>()) : kind_of(*value);
  object.refuse(kKey, "expected \"linear\" or \"dual-quaternion\", found " + found);
  return std::nullopt;
}

SceneFile::Model read_model(const std::string& name, const json& value, const std::string& path,
                            Problem& problem) {
  if (value.is_string()) return {name, value.get<std::string>()};
  const StrictObject object(value, path, kModelKeys, problem);
  return {name, read_source(object), read_skinning(object)};
}

std::vector<SceneFile::Model> read_models(const StrictObject& file, Problem& problem) {
  file.require("models");
  std::vector<SceneFile::Model> models;
  const json& members = file.members("models");
  for (auto member = members.begin(); member != members.end(); ++member) {
    models.push_back(read_model(member.key(), member.value(),
                                file.path_of("models") + "." + member.key(), problem));
  }
  return models;
}

std::uint32_t read_character(const StrictObject& object, std::span<const SceneFile::Model> models) {
  object.require("model");
  const std::string name = object.text("model").value_or("");
  std::vector<std::string_view> names;
  for (const SceneFile::Model& model : models) names.push_back(model.name);
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) {
    object.refuse("model",
                  text::quoted(name) + " is not in \"models\"" + text::suggestion(name, names));
  }
  return static_cast<std::uint32_t>(found - names.begin());
}

/// Accepts rotations written with a few decimals, whose length is nearly 1. Others are mistakes.
void require_unit_length(const StrictObject& object, const std::array<double, 4>& q) {
  constexpr double kTolerance = 1e-3;
  const double length = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
  if (std::fabs(length - 1) <= kTolerance) return;
  object.refuse("rotation", "expected a unit quaternion x y z w, found one of length " +
                                std::to_string(length));
}

template <std::size_t N>
std::array<double, N> read_vector(const StrictObject& object, std::string_view key,
                                  const std::array<double, N>& otherwise) {
  const std::array<double, N> vector = object.numbers(key, otherwise);
  for (const double number : vector) {
    if (!(std::fabs(number) <= kMaxNumber)) object.refuse(key, "expected numbers within 1e12");
  }
  return vector;
}

/// Reads an array with one number per target, or an object that maps names of targets to numbers.
std::vector<MorphWeight> read_morph_weights(const StrictObject& object) {
  constexpr std::string_view kKey = "morph_weights";
  std::vector<MorphWeight> weights;
  const json* value = object.find(kKey);
  if (value == nullptr) return weights;
  if (!value->is_array() && !value->is_object()) {
    object.refuse(kKey, "expected an object or an array, found " + kind_of(*value));
    return weights;
  }
  for (auto member = value->begin(); member != value->end(); ++member) {
    const std::string place = value->is_array() ? "element " + std::to_string(weights.size())
                                                : text::quoted(member.key());
    const double number = member->is_number() ? member->get<double>() : 0;
    if (!member->is_number())
      object.refuse(kKey, "expected a number for " + place + ", found " + kind_of(*member));
    if (!(std::fabs(number) <= kMaxNumber))
      object.refuse(kKey, "expected a number within 1e12 for " + place);
    MorphWeight weight = {static_cast<std::uint32_t>(weights.size()), static_cast<float>(number)};
    if (value->is_object()) weight.target = member.key();
    weights.push_back(std::move(weight));
  }
  return weights;
}

Instance read_instance(const StrictObject& object, std::span<const SceneFile::Model> models) {
  Instance instance;
  instance.character = read_character(object, models);
  instance.clip = object.text("clip");
  instance.start = object.number("start", instance.start, kAnyNumber);
  instance.speed = object.number("speed", instance.speed, kAnyNumber);
  instance.translation = read_vector(object, "translation", instance.translation);
  instance.rotation = read_vector(object, "rotation", instance.rotation);
  require_unit_length(object, instance.rotation);
  instance.scale = object.number("scale", instance.scale, {kMinScale, kMaxScale});
  instance.velocity = read_vector(object, "velocity", instance.velocity);
  instance.morph_weights = read_morph_weights(object);
  return instance;
}

std::vector<Instance> read_instances(const StrictObject& file,
                                     std::span<const SceneFile::Model> models) {
  file.require("instances");
  std::vector<Instance> instances;
  for (const StrictObject& object : file.objects("instances", kInstanceKeys)) {
    instances.push_back(read_instance(object, models));
  }
  return instances;
}

/// Reads an array of pairs of names.
std::vector<NamePair> read_ignore(const StrictObject& file) {
  constexpr std::string_view kKey = "ignore";
  std::vector<NamePair> pairs;
  const json* value = file.find(kKey);
  if (value == nullptr) return pairs;
  if (!value->is_array()) {
    file.refuse(kKey, "expected an array of pairs of names, found " + kind_of(*value));
    return pairs;
  }
  for (const json& pair : *value) {
    if (!pair.is_array() || pair.size() != 2 || !pair[0].is_string() || !pair[1].is_string()) {
      file.refuse(kKey, "expected two names for element " + std::to_string(pairs.size()) +
                            ", as in [\"cape\", \"spine\"]");
      return pairs;
    }
    pairs.push_back({pair[0].get<std::string>(), pair[1].get<std::string>()});
  }
  return pairs;
}

std::optional<SelfContacts> read_self(const StrictObject& file) {
  const json* value = file.find("self");
  if (value == nullptr) return std::nullopt;
  if (value->is_boolean()) return value->get<bool>() ? SelfContacts::beside : SelfContacts::none;
  if (*value == "only") return SelfContacts::only;
  file.refuse("self", "expected true, false or \"only\"");
  return std::nullopt;
}

/// Reads "keep" or "drop".
std::optional<bool> read_drops(const StrictObject& file, std::string_view key) {
  const json* value = file.find(key);
  if (value == nullptr) return std::nullopt;
  if (*value == "keep" || *value == "drop") return *value == "drop";
  file.refuse(key, "expected \"keep\" or \"drop\"");
  return std::nullopt;
}

std::optional<double> read_always(const StrictObject& file) {
  constexpr std::string_view kKey = "self_always";
  const json* value = file.find(kKey);
  if (value == nullptr) return std::nullopt;
  if (*value == "keep") return 0;
  const double share = value->is_number() ? value->get<double>() : 0;
  if (share > 0 && share <= 1) return share;
  file.refuse(kKey, "expected \"keep\" or a share of the frames, more than 0 and at most 1");
  return std::nullopt;
}

SelfOptions read_self_options(const StrictObject& file) {
  SelfOptions self;
  self.wanted = read_self(file);
  if (file.has("self_rings")) self.rings = file.count("self_rings", 0, {0, kMaxSelfRings});
  self.drops_at_rest = read_drops(file, "self_at_rest");
  self.always = read_always(file);
  self.drops_near_joints = read_drops(file, "self_near_joints");
  return self;
}

}  // namespace

Result<SceneFile> parse_scene_file(std::string_view text) {
  const Result<asset::ParsedJson> parsed = asset::parse_json(text);
  if (!parsed) return parsed.error();
  Problem problem;
  const StrictObject file(**parsed, "", kSceneKeys, problem);
  SceneFile scene;
  scene.models = read_models(file, problem);
  const StrictObject frames = file.object("frames", kFramesKeys);
  scene.frame_count = frames.count("count", scene.frame_count, {1, kMaxFrames});
  scene.fps = frames.number("fps", scene.fps, {kMinFps, kMaxFps});
  scene.instances = read_instances(file, scene.models);
  if (frames.has("count") &&
      std::any_of(scene.instances.begin(), scene.instances.end(), plays_all_clips))
    frames.refuse("count",
                  "cannot be combined with \"clip\": \"*\", which plays each clip once: "
                  "leave it out");
  scene.ignore = read_ignore(file);
  scene.self = read_self_options(file);
  if (problem) return text::malformed(*problem);
  return scene;
}

}  // namespace pelt::scenes

#include "scenes/scene.hpp"

#include <pelt/model.hpp>

#include "asset/container.hpp"
#include "asset/file_bytes.hpp"
#include "asset/read_gltf.hpp"
#include "asset/transform.hpp"
#include "base/assert.hpp"
#include "base/hash.hpp"
#include "scenes/excluded_nodes.hpp"
#include "scenes/scene_file.hpp"
#include "scenes/takes.hpp"
#include "text/message.hpp"

#include <cmath>

namespace pelt::scenes {
namespace {

constexpr const char* kNoScene =
    "is a model, not a scene: write a scene that refers to it, see docs/scenes.md";
constexpr const char* kRelative = ": paths in a scene are relative to its folder";

Result<Character> make_character(const SceneFile::Model& model, const std::filesystem::path& folder,
                                 const asset::GltfOptions& options) {
  if (const auto* creature = std::get_if<CreatureOptions>(&model.source))
    return generate_character(*creature);
  if (const auto* face = std::get_if<FaceOptions>(&model.source)) return generate_character(*face);
  const std::string& path = std::get<std::string>(model.source);
  Result<Character> character = load_character(folder / path, options_for(model.name, options));
  if (character) character->source = path;
  return character;
}

Result<Scene> make_scene(const SceneFile& file, const std::filesystem::path& folder,
                         const asset::GltfOptions& options) {
  Scene scene;
  scene.instances = file.instances;
  scene.frame_count = file.frame_count;
  scene.fps = file.fps;
  scene.ignore = file.ignore;
  scene.self = file.self;
  for (const SceneFile::Model& model : file.models) {
    Result<Character> character = make_character(model, folder, options);
    if (!character) {
      Error error = text::prefixed("models." + model.name, character.error());
      if (error.code == ErrorCode::unreadable_file) error.message += kRelative;
      return error;
    }
    character->name = model.name;
    character->skinning = model.skinning;
    scene.characters.push_back(std::move(*character));
  }
  if (const auto known = check_excluded(scene, options); !known) return known.error();
  for (std::uint32_t i = 0; i < scene.instances.size(); ++i) {
    const std::string place = "instances[" + std::to_string(i) + "].";
    if (const auto found = check_clip(scene, i); !found)
      return text::prefixed(place + "clip", found.error());
    if (const auto found = check_morph_weights(scene, i); !found)
      return text::prefixed(place + "morph_weights", found.error());
  }
  if (const auto planned = plan_takes(scene); !planned)
    return text::prefixed("instances", planned.error());
  return scene;
}

/// Returns a time in [0, duration). The rule against libm does not apply to `fmod`: IEEE 754
/// defines it exactly, so it has the same bits everywhere.
double wrapped(double seconds, double duration) {
  if (!(duration > 0)) return 0;
  const double rest = std::fmod(seconds, duration);
  const double wrapped = rest < 0 ? rest + duration : rest;
  return wrapped < duration ? wrapped : 0;  // a tiny negative remainder rounds up to the duration
}

Matrix4 placement(const Instance& instance, double seconds) {
  std::array<double, 3> position = instance.translation;
  for (int i = 0; i < 3; ++i) position[i] += instance.velocity[i] * seconds;
  const auto& r = instance.rotation;
  const asset::Quaternion rotation = asset::normalised({r[0], r[1], r[2], r[3]});
  const double scale = instance.scale;
  return asset::matrix_of(asset::compose(position, rotation, {scale, scale, scale}));
}

const Character& character_of(const Scene& scene, std::uint32_t instance) {
  return scene.characters[scene.instances[instance].character];
}

const asset::Asset& asset_of(const Scene& scene, std::uint32_t instance) {
  return character_of(scene, instance).asset;
}

bool names(const MorphWeight& morph, const asset::Asset& asset, std::size_t target) {
  if (const auto* index = std::get_if<std::uint32_t>(&morph.target)) return *index == target;
  return std::get<std::string>(morph.target) == asset.morph_targets[target].name;
}

/// Describes why `morph` matches no target, starting with the character's name.
std::string why_none(const MorphWeight& morph, const Character& character) {
  const auto& targets = character.asset.morph_targets;
  const std::string begin = text::quoted(character.name) + " has ";
  if (targets.empty()) return begin + "no morph targets";
  if (std::holds_alternative<std::uint32_t>(morph.target))
    return begin + std::to_string(targets.size()) + " morph targets, found more weights than these";
  const std::string& name = std::get<std::string>(morph.target);
  std::vector<std::string_view> known;
  known.reserve(targets.size());
  for (const asset::MorphTarget& target : targets) known.push_back(target.name);
  return begin + "no morph target " + text::quoted(name) + text::suggestion(name, known);
}

const asset::Clip* clip_of(const asset::Asset& asset, const Instance& instance) {
  const asset::Clip* clip = instance.clip ? asset.find_clip(*instance.clip) : nullptr;
  PELT_ASSERT(!instance.clip || clip != nullptr);
  return clip;
}

/// Returns the time in the clip of an instance; 0 without a clip.
float clip_time(const asset::Clip* clip, const Instance& instance, double seconds) {
  const double duration = clip != nullptr ? static_cast<double>(clip->duration) : 0;
  const double time = instance.start + instance.speed * seconds;
  return static_cast<float>(wrapped(time, duration));
}

void write_palette(const asset::Asset& asset, const asset::Clip* clip, const Instance& instance,
                   double seconds, asset::SampleScratch& scratch, std::span<Matrix4> palette) {
  const float clip_seconds = clip_time(clip, instance, seconds);
  asset::sample_palette(asset, clip, clip_seconds, placement(instance, seconds), scratch, palette);
}

void write_morph_weights(const asset::Asset& asset, const asset::Clip* clip,
                         const Instance& instance, double seconds, std::span<float> weights) {
  asset::sample_morph_weights(asset, clip, clip_time(clip, instance, seconds), weights);
  for (const MorphWeight& morph : instance.morph_weights)
    for (std::size_t m = 0; m < weights.size(); ++m)
      if (names(morph, asset, m)) weights[m] = morph.weight;
}

Result<Scene> read_scene(const std::filesystem::path& path, const asset::GltfOptions& options) {
  const Result<std::vector<std::byte>> bytes = asset::read_file(path);
  if (!bytes) return bytes.error();
  const std::string_view text(reinterpret_cast<const char*>(bytes->data()), bytes->size());
  if (text.starts_with("glTF") || is_prepared_model(*bytes))
    return text::prefixed(path.string(), text::malformed(kNoScene));
  Result<Scene> scene = parse_scene(text, path.parent_path(), options);
  if (!scene) return text::prefixed(path.string(), scene.error());
  scene->name = path.filename().string();
  return scene;
}

constexpr const char* kPrepared =
    "is a prepared model, which has no skeleton and no clips: give the glTF file that it was "
    "prepared from";

std::uint64_t hash_of(std::span<const std::byte> bytes) {
  detail::Fnv1a64 hash;
  hash.add_bytes(bytes);
  return hash.value();
}

template <typename Options>
Character generated(const char* name, const std::string& source, asset::Asset&& asset,
                    const Options& options) {
  return {name, source, hash_of(std::as_bytes(std::span(source))), std::move(asset), options};
}

Result<void> check_beginning(std::span<const std::byte> beginning) {
  if (is_prepared_model(beginning)) return text::unsupported(kPrepared);
  return asset::check_beginning(beginning);
}

Result<Character> read_character(const std::filesystem::path& path,
                                 const asset::GltfOptions& options) {
  const Result<std::vector<std::byte>> file = asset::read_file(path, check_beginning);
  if (!file) return file.error();
  // A path without a folder is relative to the working directory; an empty folder would mean that
  // there are no external files.
  const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
  Result<asset::ReadGltf> read = asset::read_gltf(*file, folder, options);
  if (!read) return text::prefixed(path.string(), read.error());
  return Character{path.stem().string(),   path.string(), hash_of(*file),
                   std::move(read->asset), path,          std::move(read->views)};
}

}  // namespace

const char* name_of(Skinning skinning) {
  return skinning == Skinning::linear ? "linear" : "dual-quaternion";
}

Result<Scene> load_scene(const std::filesystem::path& path, const asset::GltfOptions& options) {
  return asset::within_memory(path, [&] { return read_scene(path, options); });
}

Result<Scene> parse_scene(std::string_view text, const std::filesystem::path& folder,
                          const asset::GltfOptions& options) {
  const Result<SceneFile> file = parse_scene_file(text);
  if (!file) return file.error();
  return make_scene(*file, folder, options);
}

Result<void> check_clip(const Scene& scene, std::uint32_t instance) {
  const std::optional<std::string>& clip = scene.instances[instance].clip;
  if (plays_all_clips(scene.instances[instance]))
    return check_all_clips(character_of(scene, instance));
  const asset::Asset& asset = asset_of(scene, instance);
  if (!clip || asset.find_clip(*clip) != nullptr) return {};
  const std::string& character = character_of(scene, instance).name;
  const std::string problem = text::quoted(character) + " has no clip " + text::quoted(*clip);
  if (asset.clips.empty()) return Error{ErrorCode::invalid_argument, problem + ", it has none"};
  std::vector<std::string_view> names;
  for (const asset::Clip& known : asset.clips) names.push_back(known.name);
  return Error{ErrorCode::invalid_argument, problem + text::suggestion(*clip, names)};
}

Result<void> check_morph_weights(const Scene& scene, std::uint32_t instance) {
  const Character& character = character_of(scene, instance);
  for (const MorphWeight& morph : scene.instances[instance].morph_weights) {
    bool is_known = false;
    for (std::size_t m = 0; m < character.asset.morph_targets.size(); ++m)
      is_known |= names(morph, character.asset, m);
    if (!is_known) return Error{ErrorCode::invalid_argument, why_none(morph, character)};
  }
  return {};
}

double frame_time(const Scene& scene, std::uint32_t frame) {
  return moment_time(scene, {frame, 0});
}

double moment_time(const Scene& scene, const Moment& moment) {
  return (frame_in_take(scene, moment.frame) + moment.later) / scene.fps;
}

void instance_palette(const Scene& scene, std::uint32_t instance, std::uint32_t frame,
                      asset::SampleScratch& scratch, std::span<Matrix4> palette) {
  instance_palette(scene, instance, Moment{frame, 0}, scratch, palette);
}

void instance_palette(const Scene& scene, std::uint32_t instance, const Moment& moment,
                      asset::SampleScratch& scratch, std::span<Matrix4> palette) {
  write_palette(asset_of(scene, instance), clip_in(scene, instance, find_take(scene, moment.frame)),
                scene.instances[instance], moment_time(scene, moment), scratch, palette);
}

void instance_morph_weights(const Scene& scene, std::uint32_t instance, std::uint32_t frame,
                            std::span<float> weights) {
  instance_morph_weights(scene, instance, Moment{frame, 0}, weights);
}

void instance_morph_weights(const Scene& scene, std::uint32_t instance, const Moment& moment,
                            std::span<float> weights) {
  write_morph_weights(asset_of(scene, instance),
                      clip_in(scene, instance, find_take(scene, moment.frame)),
                      scene.instances[instance], moment_time(scene, moment), weights);
}

void instance_palette(const asset::Asset& asset, const Instance& instance, double seconds,
                      asset::SampleScratch& scratch, std::span<Matrix4> palette) {
  write_palette(asset, clip_of(asset, instance), instance, seconds, scratch, palette);
}

void instance_morph_weights(const asset::Asset& asset, const Instance& instance, double seconds,
                            std::span<float> weights) {
  write_morph_weights(asset, clip_of(asset, instance), instance, seconds, weights);
}

Result<Character> load_character(const std::filesystem::path& path,
                                 const asset::GltfOptions& options) {
  return asset::within_memory(path, [&] { return read_character(path, options); });
}

Result<Character> generate_character(const CreatureOptions& options) {
  Result<asset::Asset> creature = make_creature(options);
  if (!creature) return creature.error();
  const std::string source = "creature:" + std::to_string(options.triangles) + ":" +
                             std::to_string(options.joints) + ":" + std::to_string(options.seed);
  return generated("creature", source, std::move(*creature), options);
}

Result<Character> generate_character(const FaceOptions& options) {
  Result<asset::Asset> face = make_face(options);
  if (!face) return face.error();
  const std::string source =
      "face:" + std::to_string(options.triangles) + ":" + std::to_string(options.seed);
  return generated("face", source, std::move(*face), options);
}

}  // namespace pelt::scenes

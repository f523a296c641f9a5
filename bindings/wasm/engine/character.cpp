/// Characters: read, generated, described.

#include <pelt/bounds.hpp>
#include <pelt/model.hpp>

#include "bindings/wasm/engine/answer.hpp"
#include "bindings/wasm/engine/export.hpp"
#include "bindings/wasm/engine/handles.hpp"
#include "bindings/wasm/engine/options.hpp"
#include "bounds/level_boxes.hpp"
#include "model/model.hpp"
#include "model/surface.hpp"
#include "scenes/clip_samples.hpp"
#include "scenes/names.hpp"
#include "text/message.hpp"

#include <nlohmann/json.hpp>

#include <numeric>

namespace pelt::wasm {
namespace {

using nlohmann::json;

/// Builds a model. Skips sample poses that are not valid for the model.
Result<SkinnedModel> build(const asset::Asset& asset, SkinnedMeshView mesh,
                           const Preparation& preparation) {
  mesh.offset_caps = preparation.offset_caps;
  const std::vector<Matrix4> samples =
      scenes::clip_samples(asset, preparation.clips, preparation.samples);
  ModelOptions options;
  if (preparation.renormalise) options.off_weights = OffWeights::renormalise;
  options.skinning = preparation.skinning.value_or(Skinning::linear);
  options.weld = preparation.weld;
  options.sample_palettes = samples;
  Result<SkinnedModel> model = build_model(mesh, options);
  if (model || samples.empty()) return model;
  options.sample_palettes = {};
  return build_model(mesh, options);
}

Result<scenes::Character> read_file(std::span<const std::byte> file, const Options& options) {
  const std::string name = options.text("name");
  if (is_prepared_model(file))
    return text::prefixed(name, text::unsupported("is a prepared model: read the glTF file "
                                                  "that it was prepared from"));
  Result<asset::Asset> read = asset::load_gltf(file, options.text("folder"), options.gltf());
  if (!read) return text::prefixed(name, read.error());
  return scenes::Character{name, name, 0, std::move(*read)};
}

/// Uses the clips named in the options, or the first clips. `caps` are those of the vertices, or
/// empty if the options have one for all vertices, or none.
Result<Preparation> choose_preparation(const asset::Asset& asset, std::span<const float> caps,
                                       const Options& options) {
  Preparation preparation = options.preparation();
  preparation.offset_caps.assign(caps.begin(), caps.end());
  if (const std::optional<float> cap = options.number("offsetCaps"))
    preparation.offset_caps.assign(asset.rest_positions.size(), *cap);
  const std::optional<std::vector<std::string>> names = options.texts("clips");
  if (!names) {
    preparation.clips = scenes::first_clips(asset, preparation.samples);
    return preparation;
  }
  for (const std::string& name : *names) {
    const asset::Clip* clip = asset.find_clip(name);
    if (clip == nullptr) {
      std::vector<std::string_view> known;
      for (const asset::Clip& one : asset.clips) known.push_back(one.name);
      return Error{ErrorCode::invalid_argument,
                   "clips: there is no clip " + text::quoted(name) + text::suggestion(name, known)};
    }
    preparation.clips.push_back(clip);
  }
  return preparation;
}

Result<CharacterHandle*> prepare_read(Result<scenes::Character> read, std::span<const float> caps,
                                      const Options& options) {
  if (!read) return read.error();
  const Result<Preparation> preparation = choose_preparation(read->asset, caps, options);
  if (!preparation) return text::prefixed(read->name, preparation.error());
  Result<CharacterHandle> handle = prepare(std::move(*read), *preparation);
  if (!handle) return handle.error();
  return new CharacterHandle(std::move(*handle));
}

Result<CharacterHandle*> prepare_generated(Result<scenes::Character> generated,
                                           std::span<const float> caps, const Options& options) {
  if (const std::string name = options.text("name"); generated && !name.empty())
    generated->name = name;
  return prepare_read(std::move(generated), caps, options);
}

/// Returns a character whose vertices all follow one joint.
scenes::Character make_rigid(const std::string& name, std::span<const Vec3> rest_positions,
                             std::span<const Triangle> triangles) {
  asset::Asset asset;
  asset.rest_positions.assign(rest_positions.begin(), rest_positions.end());
  asset.triangles.assign(triangles.begin(), triangles.end());
  asset.joint_indices.resize(rest_positions.size());
  asset.weights.assign(rest_positions.size(), 1);
  asset.joints.emplace_back();
  asset.nodes.emplace_back().name = name;
  asset::Part& part = asset.parts.emplace_back();
  part.node = name;
  part.triangle_count = static_cast<std::uint32_t>(triangles.size());
  return {name, name, 0, std::move(asset)};
}

json describe_parts(const asset::Asset& asset) {
  json parts = json::array();
  const std::vector<std::string> names = scenes::part_names(asset);
  for (std::uint32_t p = 0; p < asset.parts.size(); ++p) {
    const asset::Part& part = asset.parts[p];
    parts.push_back({{"name", names[p]},
                     {"firstTriangle", part.first_triangle},
                     {"triangleCount", part.triangle_count},
                     {"skinned", part.skinned}});
  }
  return parts;
}

json describe(const Character& character) {
  const asset::Asset& asset = character.asset();
  const detail::Tree& tree = character.whole.model.detail().tree;
  json clips = json::array(), joints = json::array(), targets = json::array();
  for (const asset::Clip& clip : asset.clips)
    clips.push_back({{"name", clip.name}, {"seconds", clip.duration}});
  for (std::uint32_t j = 0; j < asset.joints.size(); ++j)
    joints.push_back(scenes::joint_name(asset, j));
  for (const asset::MorphTarget& target : asset.morph_targets) targets.push_back(target.name);
  return {{"name", character.read.name},
          {"vertexCount", asset.rest_positions.size()},
          {"triangleCount", asset.triangles.size()},
          {"jointCount", asset.joints.size()},
          {"nodeCount", tree.nodes.size()},
          {"levelCount", detail::level_count(tree)},
          {"parts", describe_parts(asset)},
          {"clips", std::move(clips)},
          {"jointNames", std::move(joints)},
          {"morphTargetNames", std::move(targets)},
          {"warnings", asset.warnings}};
}

}  // namespace

const std::vector<std::uint32_t>& Character::get_seams() {
  if (!seams.empty()) return seams;
  constexpr std::uint32_t kNone = 0xFFFFFFFF;
  std::vector<std::uint32_t> first(whole.model.vertex_count(), kNone);  // of each surface vertex
  seams.resize(first.size());
  std::iota(seams.begin(), seams.end(), 0u);
  for (std::size_t t = 0; t < asset().triangles.size(); ++t)
    for (std::size_t c = 0; c < 3; ++c) {
      const std::uint32_t vertex = asset().triangles[t][c];
      std::uint32_t& known = first[whole.model.surface().detail().corners[t][c]];
      if (known == kNone) known = vertex;
      seams[vertex] = known;
    }
  return seams;
}

Result<Body*> Character::body(std::uint32_t number) {
  if (number == kWhole) return &whole;
  parts.resize(asset().parts.size());
  if (number >= parts.size() || asset().parts[number].triangle_count == 0) {
    return Error{ErrorCode::invalid_argument, "part: " + text::quoted(read.name) + " has no part " +
                                                  std::to_string(number) + " with triangles"};
  }
  if (parts[number]) return parts[number].get();
  const asset::Part& part = asset().parts[number];
  SkinnedMeshView mesh = asset().mesh();
  mesh.triangles = mesh.triangles.subspan(part.first_triangle, part.triangle_count);
  Result<SkinnedModel> model = build(asset(), mesh, preparation);
  if (!model) return text::prefixed(read.source, in_words_of_javascript(model.error()));
  parts[number] = std::make_unique<Body>(Body{std::move(*model), part.first_triangle});
  return parts[number].get();
}

Scratch& scratch() {
  static Scratch scratch;
  return scratch;
}

asset::SampleScratch& sample_scratch() {
  static asset::SampleScratch scratch;
  return scratch;
}

Result<CharacterHandle> prepare(scenes::Character read, Preparation preparation) {
  if (!preparation.skinning) preparation.skinning = read.skinning;
  Result<SkinnedModel> model = build(read.asset, read.asset.mesh(), preparation);
  if (!model) return text::prefixed(read.source, in_words_of_javascript(model.error()));
  return CharacterHandle{std::make_shared<Character>(
      Character{std::move(read), std::move(preparation), {std::move(*model), 0}, {}, {}})};
}

/// The parameters `caps` and `json`, also of the next functions, are those of choose_preparation.
Result<CharacterHandle*> read_character(std::span<const std::byte> file,
                                        std::span<const float> caps, std::string_view json) {
  const Result<Options> options = Options::read(json);
  if (!options) return options.error();
  return prepare_read(read_file(file, *options), caps, *options);
}
PELT_EXPORT(read_character)

Result<CharacterHandle*> make_character(std::span<const Vec3> rest_positions,
                                        std::span<const Triangle> triangles,
                                        std::span<const float> caps, std::string_view json) {
  const Result<Options> options = Options::read(json);
  if (!options) return options.error();
  return prepare_read(make_rigid(options->text("name"), rest_positions, triangles), caps, *options);
}
PELT_EXPORT(make_character)

Result<CharacterHandle*> generate_creature(std::span<const float> caps, std::string_view json) {
  const Result<Options> options = Options::read(json);
  if (!options) return options.error();
  return prepare_generated(scenes::generate_character(options->creature()), caps, *options);
}
PELT_EXPORT(generate_creature)

Result<CharacterHandle*> generate_face(std::span<const float> caps, std::string_view json) {
  const Result<Options> options = Options::read(json);
  if (!options) return options.error();
  return prepare_generated(scenes::generate_character(options->face()), caps, *options);
}
PELT_EXPORT(generate_face)

void delete_character(CharacterHandle* handle) { delete handle; }
PELT_EXPORT(delete_character)

const char* describe_character(const CharacterHandle& handle) {
  return answer_json(describe(*handle.character));
}
PELT_EXPORT(describe_character)

void triangles(const CharacterHandle& handle) {
  answer_arrays(handle.character->asset().triangles);
}
PELT_EXPORT(triangles)

void rest_positions(const CharacterHandle& handle) {
  answer_arrays(handle.character->asset().rest_positions);
}
PELT_EXPORT(rest_positions)

void triangle_joints(const CharacterHandle& handle) {
  answer_arrays(handle.character->whole.model.surface().detail().joints);
}
PELT_EXPORT(triangle_joints)

/// Answers with the box of the character's default pose.
Result<void> extent(const CharacterHandle& handle) {
  const Character& character = *handle.character;
  std::vector<Matrix4> palette(character.asset().joints.size());
  asset::sample_palette(character.asset(), nullptr, 0, {}, sample_scratch(), palette);
  Pose pose(character.whole.model);
  if (const Result<void> set = pose.set_palette(palette); !set)
    return text::prefixed(character.read.name, set.error());
  Bounds found;
  exact_bounds(pose, found);
  answer_box(found.box);
  return {};
}
PELT_EXPORT(extent)

}  // namespace pelt::wasm

#include "tools/pelt/arguments/model_arguments.hpp"

#include "asset/file_bytes.hpp"
#include "scenes/excluded_nodes.hpp"
#include "skin/skinned_mesh.hpp"
#include "text/message.hpp"

#include <filesystem>

namespace pelt::tools::arguments {
namespace {

bool is_named_as_gltf(const std::filesystem::path& path) {
  return path.extension() == ".glb" || path.extension() == ".gltf";
}

ModelOptions options_of(const scenes::Character& character, const ModelArguments& arguments) {
  ModelOptions options;
  if (arguments.renormalise) options.off_weights = OffWeights::renormalise;
  options.skinning = arguments.skinning_of(character);
  return options;
}

/// Names the source, and the command's option as the remedy.
Error named_error(const std::string& source, const Error& error) {
  std::string message = source + ": " + error.message;
  const std::string in_code = "off_weights = OffWeights::renormalise";
  if (const std::size_t at = message.find(in_code); at != message.npos)
    message.replace(at, in_code.size(), "--renormalise");
  return {error.code, message};
}

}  // namespace

Skinning ModelArguments::skinning_of(const scenes::Character& character) const {
  if (skinning.empty()) return character.skinning.value_or(Skinning::linear);
  return skinning == scenes::name_of(Skinning::linear) ? Skinning::linear
                                                       : Skinning::dual_quaternion;
}

asset::GltfOptions ModelArguments::gltf_options() const {
  asset::GltfOptions options;
  options.unskinned_parts = !no_unskinned;
  options.exclude_nodes = exclude;
  return options;
}

void add_model_options(Verb& verb, ModelArguments& arguments) {
  verb.flag("--no-unskinned", arguments.no_unskinned,
            "Leave out meshes without a skin (weapons, armour)");
  verb.option("--exclude", arguments.exclude,
              "Leave out the mesh node of this name and its children; knight/Cape names a node of "
              "one model (repeatable)",
              {.type = "NAME"});
  verb.flag("--renormalise", arguments.renormalise,
            "Accept weights that do not sum to 1, and divide them by their sum, as renderers do");
  verb.choice("--skinning", arguments.skinning, "dual-quaternion|linear",
              "How joints are blended, which models do not say, but scenes may: linear, or by dual "
              "quaternions, which need joints without scale. Does not apply to prepared models");
  verb.option(
      "--samples", arguments.samples,
      "Number of sample poses, taken from clips, that a character is optimised for; 0 makes "
      "building faster and queries slower",
      {.type = "N", .most = 1000});
}

Result<scenes::Character> load_named_character(const std::string& path,
                                               const asset::GltfOptions& options,
                                               const char* kinds) {
  const std::string name = std::filesystem::path(path).stem().string();
  asset::GltfOptions own = scenes::options_for(name, options);
  own.excluded_must_exist = options.excluded_must_exist;
  Result<scenes::Character> character = scenes::load_character(path, own);
  if (character || character.error().code != ErrorCode::malformed_file || is_named_as_gltf(path))
    return character;
  return text::bad_argument(path, "is not a model", std::string("give ") + kinds);
}

Result<SkinnedModel> build_named_model(const scenes::Character& character,
                                       const SkinnedMeshView& mesh, const ModelArguments& arguments,
                                       std::span<const Matrix4> sample_palettes) {
  ModelOptions options = options_of(character, arguments);
  options.sample_palettes = sample_palettes;
  Result<SkinnedModel> model =
      asset::within_memory(character.source, [&] { return build_model(mesh, options); });
  if (!model && model.error().code == ErrorCode::unreadable_file) return model;
  if (!model && !sample_palettes.empty()) return build_named_model(character, mesh, arguments);
  if (model) return model;
  return named_error(character.source, model.error());
}

Result<detail::Palette> make_named_palette(const scenes::Character& character,
                                           const SkinnedMeshView& mesh,
                                           const ModelArguments& arguments) {
  BuildReport report;
  const auto checked = asset::within_memory(character.source, [&] {
    return detail::make_skinned_mesh(mesh, options_of(character, arguments), report);
  });
  if (checked)
    return detail::Palette(checked->joint_count, checked->rest_extent, checked->morph_extents,
                           checked->dual_influences);
  if (checked.error().code == ErrorCode::unreadable_file) return checked.error();
  return named_error(character.source, checked.error());
}

}  // namespace pelt::tools::arguments

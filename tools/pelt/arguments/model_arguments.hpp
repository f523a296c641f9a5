#pragma once

#include <pelt/asset.hpp>
#include <pelt/model.hpp>

#include "scenes/scene.hpp"
#include "skin/palette.hpp"
#include "tools/pelt/arguments/verb.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace pelt::tools::arguments {

/// Options for reading and building models, of every verb that reads models.
struct ModelArguments {
  bool no_unskinned = false;
  std::vector<std::string> exclude;
  bool renormalise = false;
  std::uint32_t samples = 6;  ///< sample poses for optimising the bounds
  std::string skinning;       ///< empty: as the scene says, or linear

  /// The kind of skinning with which the model of a character is built.
  Skinning skinning_of(const scenes::Character& character) const;

  asset::GltfOptions gltf_options() const;
};

void add_model_options(Verb& verb, ModelArguments& arguments);

/// Loads a character. `kinds` lists the allowed kinds of files, for the message about another kind.
Result<scenes::Character> load_named_character(const std::string& path,
                                               const asset::GltfOptions& options,
                                               const char* kinds);

/// build_model of the mesh of a character, or of one of its parts, with messages for the command:
/// the message names the source of the character, and the remedy is an option of the command. Skips
/// sample poses that are not valid for the model, because a clip may be invalid at times that no
/// frame uses.
Result<SkinnedModel> build_named_model(const scenes::Character& character,
                                       const SkinnedMeshView& mesh, const ModelArguments& arguments,
                                       std::span<const Matrix4> sample_palettes = {});

/// Validates a mesh without building a model, and returns its palette in the rest pose. Returns the
/// errors of build_named_model.
Result<detail::Palette> make_named_palette(const scenes::Character& character,
                                           const SkinnedMeshView& mesh,
                                           const ModelArguments& arguments);

}  // namespace pelt::tools::arguments

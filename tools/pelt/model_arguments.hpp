#pragma once

#include <pelt/asset.hpp>
#include <pelt/model.hpp>

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace pelt::tools {

/// How models are read, on the command line of every verb that reads any.
struct ModelArguments {
  bool no_unskinned = false;
  std::vector<std::string> exclude;
  bool renormalise = false;

  asset::GltfOptions gltf_options() const;
  ModelOptions model_options() const;
};

void add_model_options(CLI::App& verb, ModelArguments& arguments);

/// build_model with words that fit the command: the message names `source`, and the remedy is an
/// option of the command.
Result<SkinnedModel> build_named_model(const std::string& source, const SkinnedMeshView& mesh,
                                       const ModelOptions& options);

}  // namespace pelt::tools

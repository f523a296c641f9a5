#pragma once

/// The files that a verb reads, which no output may replace.

#include "tools/pelt/arguments/scene_arguments.hpp"
#include "tools/pelt/output/output_conflicts.hpp"

#include <string>
#include <vector>

namespace pelt::tools::arguments {

/// A model, and the buffers and images that it refers to, whether or not Pelt reads them.
std::vector<output::InputFile> files_of_model(const std::string& path);

/// The models of the scene, and its file if it has one.
std::vector<output::InputFile> files_of_scene(const SceneArguments& arguments,
                                              const scenes::Scene& scene);

}  // namespace pelt::tools::arguments

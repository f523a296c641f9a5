#include "tools/pelt/arguments/input_files.hpp"

#include "asset/referenced_files.hpp"

#include <utility>

namespace pelt::tools::arguments {

std::vector<output::InputFile> files_of_model(const std::string& path) {
  std::vector<output::InputFile> files = {{path, "the model " + path}};
  for (std::filesystem::path& file : asset::referenced_files(path))
    files.push_back({std::move(file), "a file of the model " + path});
  return files;
}

std::vector<output::InputFile> files_of_scene(const SceneArguments& arguments,
                                              const scenes::Scene& scene) {
  std::vector<output::InputFile> files;
  if (asks_for_scene(arguments))
    files.push_back({arguments.inputs[0], "the scene " + arguments.inputs[0]});
  for (const scenes::Character& character : scene.characters) {
    const auto* path = std::get_if<std::filesystem::path>(&character.origin);
    if (path == nullptr) continue;
    for (output::InputFile& file : files_of_model(path->string())) files.push_back(std::move(file));
  }
  return files;
}

}  // namespace pelt::tools::arguments

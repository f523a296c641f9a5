#pragma once

/// The text of a scene file, before the characters that it names are loaded.

#include "scenes/scene.hpp"

#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace pelt::scenes {

struct SceneFile {
  struct Model {
    std::string name;
    /// Path of a glTF file, or generated.
    std::variant<std::string, CreatureOptions, FaceOptions> source;
  };

  std::vector<Model> models;        ///< by name
  std::vector<Instance> instances;  ///< `character` is an index into `models`
  std::uint32_t frame_count = 1;
  double fps = 30;
  std::vector<NamePair> ignore;
};

/// The message of an error begins with the path inside the file. O(text) but for looking up the
/// names of models, O(instances times models); the parsed JSON is in memory on the way.
Result<SceneFile> parse_scene_file(std::string_view text);

}  // namespace pelt::scenes

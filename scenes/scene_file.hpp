#pragma once

/// Parses the text of a scene file, without loading its characters.

#include "scenes/scene.hpp"

#include <array>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace pelt::scenes {

/// Keys of the scene format, object by object, as documented in docs/scene.schema.json.
inline constexpr std::array<std::string_view, 10> kSceneKeys = {
    "$schema", "models",     "frames",       "instances",   "ignore",
    "self",    "self_rings", "self_at_rest", "self_always", "self_near_joints"};
inline constexpr std::array<std::string_view, 2> kFramesKeys = {"count", "fps"};
inline constexpr std::array<std::string_view, 4> kModelKeys = {"file", "creature", "face",
                                                               "skinning"};
inline constexpr std::array<std::string_view, 3> kCreatureKeys = {"triangles", "joints", "seed"};
inline constexpr std::array<std::string_view, 2> kFaceKeys = {"triangles", "seed"};
inline constexpr std::array<std::string_view, 9> kInstanceKeys = {
    "model",    "clip",  "start",    "speed",        "translation",
    "rotation", "scale", "velocity", "morph_weights"};

struct SceneFile {
  struct Model {
    std::string name;
    /// Path of a glTF file, or options of a generated character.
    std::variant<std::string, CreatureOptions, FaceOptions> source;
    std::optional<Skinning> skinning = {};
  };

  std::vector<Model> models;        ///< by name
  std::vector<Instance> instances;  ///< `character` is an index into `models`
  std::uint32_t frame_count = 1;
  double fps = 30;
  std::vector<NamePair> ignore;
  SelfOptions self;
};

/// Parses a scene file. Error messages start with the place in the file. O(text), and O(instances
/// times models) for looking up the names of models. The parsed JSON is in memory meanwhile.
Result<SceneFile> parse_scene_file(std::string_view text);

}  // namespace pelt::scenes

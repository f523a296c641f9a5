#pragma once

/// Which characters, where, doing what and in which frames: a scene file, or models with options.

#include "scenes/scene.hpp"
#include "tools/pelt/arguments/frame_range.hpp"
#include "tools/pelt/arguments/model_arguments.hpp"

#include <optional>
#include <string>
#include <vector>

namespace pelt::tools::arguments {

struct SceneArguments {
  std::vector<std::string> inputs;  ///< SCENE.json, or one glTF file for each instance
  std::vector<std::string> clips;   ///< these five: one for each model, in order
  std::vector<double> starts, turns, scales;
  std::vector<std::string> positions;
  std::optional<double> fps;
  ModelArguments models;
};

enum class InputsNeeded { one, none };

void add_scene_options(Verb& verb, SceneArguments& arguments,
                       InputsNeeded needed = InputsNeeded::one);

/// Whether the only input is a scene file.
bool asks_for_scene(const SceneArguments& arguments);

/// Loads what the arguments name. A scene made of models lasts as long as its longest clip, and has
/// notes where they stand still or in one place.
Result<scenes::Scene> open_scene(const SceneArguments& arguments);

/// The frames that `text` (of --frames, "" where it was not given) asks for. Models on the command
/// line have no end unless one plays all its clips: clips loop, and `scene.frame_count` follows.
/// Notes in `scene` where all of several frames are alike.
Result<FrameRange> choose_frames(const std::string& text, const SceneArguments& arguments,
                                 scenes::Scene& scene);

}  // namespace pelt::tools::arguments

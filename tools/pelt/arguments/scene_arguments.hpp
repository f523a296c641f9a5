#pragma once

/// Characters, placements, clips and frames from the command line: a scene file, or models with
/// options; and the files that a verb reads, which no output may replace.

#include "scenes/scene.hpp"
#include "tools/pelt/arguments/model_arguments.hpp"
#include "tools/pelt/arguments/values.hpp"
#include "tools/pelt/output/output_conflicts.hpp"

#include <optional>
#include <string>
#include <vector>

namespace pelt::tools::arguments {

struct SceneArguments {
  std::vector<std::string> inputs;  ///< SCENE.json, or one glTF file for each instance
  std::vector<std::string> clips;   ///< one per model, in order, like the next four
  std::vector<double> starts, turns, scales;
  std::vector<std::string> positions;
  std::optional<double> fps;
  ModelArguments models;
};

enum class InputsNeeded { one, none };

void add_scene_options(Verb& verb, SceneArguments& arguments,
                       InputsNeeded needed = InputsNeeded::one);

/// Refuses an impossible value of --fps, as `open_scene` does.
Result<void> check_fps(const std::optional<double>& fps);

/// Whether the only input is a scene file.
bool asks_for_scene(const SceneArguments& arguments);

/// Loads the inputs. A scene of models lasts as long as its longest clip. It has notes if models
/// stand still or share a position.
Result<scenes::Scene> open_scene(const SceneArguments& arguments);

/// Returns the frames of `text` (the value of --frames; "" if absent). Clips of models on the
/// command line loop, so the range may exceed `scene.frame_count`, which is then increased; this is
/// an error if a model plays all its clips. Adds a note to `scene` if the range exceeds it, or if
/// several frames would all be equal.
Result<FrameRange> choose_frames(const std::string& text, const SceneArguments& arguments,
                                 scenes::Scene& scene);

/// A model, and the buffers and images that it refers to, whether or not Pelt reads them.
std::vector<output::InputFile> files_of_model(const std::string& path);

/// The models of the scene, and its file if it has one.
std::vector<output::InputFile> files_of_scene(const SceneArguments& arguments,
                                              const scenes::Scene& scene);

}  // namespace pelt::tools::arguments

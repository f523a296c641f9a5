#include "tools/pelt/arguments/scene_arguments.hpp"

#include "asset/transform.hpp"
#include "asset/uri.hpp"
#include "scenes/excluded_nodes.hpp"
#include "scenes/takes.hpp"
#include "text/format.hpp"
#include "text/message.hpp"
#include "tools/pelt/arguments/values.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

namespace pelt::tools::arguments {
namespace {

using scenes::Instance;
using scenes::Scene;

/// The value of --clip that leaves a model in its default pose.
constexpr const char* kNoClip = "-";

bool is_scene_file(const std::string& path) {
  return std::filesystem::path(path).extension() == ".json";
}

struct PlacingOption {
  const char* name;
  std::size_t count;
};

std::array<PlacingOption, 5> placing_options(const SceneArguments& arguments) {
  return {{{"--clip", arguments.clips.size()},
           {"--start", arguments.starts.size()},
           {"--at", arguments.positions.size()},
           {"--turn", arguments.turns.size()},
           {"--scale", arguments.scales.size()}}};
}

Result<void> check_for_scene(const SceneArguments& arguments) {
  for (const PlacingOption& option : placing_options(arguments)) {
    if (option.count == 0) continue;
    return text::bad_argument(option.name,
                              "applies to models on the command line, not to a scene file",
                              "edit " + arguments.inputs[0] + " instead");
  }
  return {};
}

Result<void> check_for_models(const SceneArguments& arguments) {
  const std::size_t models = arguments.inputs.size();
  for (const std::string& input : arguments.inputs) {
    if (!is_scene_file(input)) continue;
    return text::bad_argument(input, "is a scene file, but other files are given too",
                              "give a single scene file, or models only, or a list of scenes to "
                              "check --scenes");
  }
  for (const PlacingOption& option : placing_options(arguments)) {
    if (option.count <= models) continue;
    return text::bad_argument(option.name,
                              "was given " + text::counted(option.count, "time") + " for " +
                                  text::counted(models, "model"),
                              "give it at most once per model, in the order of the models");
  }
  return {};
}

/// Rotates about the y axis, which points up; a positive angle rotates +z towards +x.
std::array<double, 4> turned(double degrees) {
  const double half_turns = degrees / 720;
  return {0, asset::sine_of_turns(half_turns), 0, asset::cosine_of_turns(half_turns)};
}

/// Element `i`, or `otherwise` if the option was given fewer times.
template <typename T>
T nth(const std::vector<T>& values, std::size_t i, const T& otherwise) {
  return i < values.size() ? values[i] : otherwise;
}

Result<Instance> place(const SceneArguments& arguments, std::size_t i) {
  Instance instance;
  const std::string clip = nth<std::string>(arguments.clips, i, kNoClip);
  if (clip != kNoClip) instance.clip = clip;
  instance.start = nth(arguments.starts, i, 0.0);
  instance.scale = nth(arguments.scales, i, 1.0);
  if (!(instance.scale >= scenes::kMinScale && instance.scale <= scenes::kMaxScale)) {
    return text::number_not_allowed("--scale", instance.scale, "give a number from 1e-6 to 1e6");
  }
  const double degrees = nth(arguments.turns, i, 0.0);
  if (!(std::fabs(degrees) <= 1e9))
    return text::number_not_allowed("--turn", degrees, "give a number from -1e9 to 1e9");
  if (!(std::fabs(instance.start) <= 1e12))
    return text::number_not_allowed("--start", instance.start, "give a number from -1e12 to 1e12");
  instance.rotation = turned(degrees);
  const Result<std::array<double, 3>> position =
      parse_position("--at", nth<std::string>(arguments.positions, i, "0,0,0"));
  if (!position) return position.error();
  instance.translation = *position;
  return instance;
}

/// With several models, a name need not exist in each of them.
asset::GltfOptions one_of_several(const ModelArguments& models) {
  asset::GltfOptions options = models.gltf_options();
  options.excluded_must_exist = false;
  return options;
}

/// A second name after --exclude is read as an input.
Error with_exclude_hint(const SceneArguments& arguments, const std::string& path, Error error) {
  std::error_code ignored;
  if (!arguments.models.exclude.empty() && !std::filesystem::exists(path, ignored))
    error.message += ": each --exclude has one name, so for another one give --exclude " + path;
  return error;
}

/// Returns the character of a file. Loads each file once, even if several instances use it.
Result<std::uint32_t> add_character(Scene& scene, const std::string& path,
                                    const asset::GltfOptions& options) {
  for (std::uint32_t c = 0; c < scene.characters.size(); ++c) {
    if (scene.characters[c].source == path) return c;
  }
  Result<scenes::Character> character =
      load_named_character(path, options, "a scene, .json, or models, .glb or .gltf");
  if (!character) return character.error();
  scene.characters.push_back(std::move(*character));
  return static_cast<std::uint32_t>(scene.characters.size() - 1);
}

Result<void> add_instance(Scene& scene, const SceneArguments& arguments, std::size_t i) {
  Result<Instance> instance = place(arguments, i);
  if (!instance) return instance.error();
  const Result<std::uint32_t> character =
      add_character(scene, arguments.inputs[i], one_of_several(arguments.models));
  if (!character) return with_exclude_hint(arguments, arguments.inputs[i], character.error());
  instance->character = *character;
  scene.instances.push_back(std::move(*instance));
  const Result<void> found = scenes::check_clip(scene, static_cast<std::uint32_t>(i));
  if (!found) return text::prefixed("--clip", found.error());
  return {};
}

/// The frames of all clips, or of the longest clip of models that play one clip each.
Result<void> choose_frame_count(Scene& scene) {
  if (const auto planned = scenes::plan_takes(scene); !planned)
    return text::prefixed("--clip", planned.error());
  if (scene.takes.empty()) scene.frame_count = scenes::frames_of_longest_clip(scene);
  return {};
}

/// Number of models that have clips and were given neither a clip nor the default pose.
std::size_t count_left_standing(const SceneArguments& arguments, const Scene& scene) {
  std::size_t count = 0;
  for (std::size_t i = arguments.clips.size(); i < scene.instances.size(); ++i)
    count += !scene.characters[scene.instances[i].character].asset.clips.empty();
  return count;
}

/// Two models without other options probably are not where the user expects them.
std::vector<std::string> placing_notes(const SceneArguments& arguments, const Scene& scene) {
  std::vector<std::string> notes;
  if (const std::size_t standing = count_left_standing(arguments, scene); standing > 0)
    notes.push_back(text::counted(standing, "model") + (standing == 1 ? " stands" : " stand") +
                    " in the default pose: select a clip for each model with --clip; pelt info "
                    "lists the clips (-: default pose)");
  if (scene.instances.size() > 1 && arguments.positions.empty())
    notes.push_back("all models are in one place: place each of them with --at X,Y,Z");
  return notes;
}

Result<Scene> scene_of_models(const SceneArguments& arguments) {
  if (const auto checked = check_for_models(arguments); !checked) return checked.error();
  Scene scene;
  scene.name = "command line";
  if (arguments.fps) scene.fps = *arguments.fps;
  for (std::size_t i = 0; i < arguments.inputs.size(); ++i) {
    if (const auto added = add_instance(scene, arguments, i); !added) return added.error();
  }
  const auto known = scenes::check_excluded(scene, arguments.models.gltf_options());
  if (!known) return text::prefixed("--exclude", known.error());
  if (const auto chosen = choose_frame_count(scene); !chosen) return chosen.error();
  scene.notes = placing_notes(arguments, scene);
  return scene;
}

bool plays_nothing(const Scene& scene) {
  return std::none_of(scene.instances.begin(), scene.instances.end(),
                      [](const Instance& instance) { return instance.clip.has_value(); });
}

/// Words for frames beyond the end of the clips, whose poses are those of earlier frames.
std::string loop_note(const Scene& scene) {
  const bool one = scene.instances.size() == 1;
  return "frames from " + std::to_string(scene.frame_count) + " on repeat the " +
         (one ? "clip, which has " : "clips, the longest of which has ") +
         text::counted(scene.frame_count, "frame");
}

Result<Scene> scene_of_file(const SceneArguments& arguments) {
  if (const auto checked = check_for_scene(arguments); !checked) return checked.error();
  Result<Scene> scene = scenes::load_scene(arguments.inputs[0], arguments.models.gltf_options());
  if (!scene || !arguments.fps) return scene;
  scene->fps = *arguments.fps;
  if (const auto planned = scenes::plan_takes(*scene); !planned)
    return text::prefixed("--fps", planned.error());
  return scene;
}

}  // namespace

void add_scene_options(Verb& verb, SceneArguments& arguments, InputsNeeded needed) {
  const auto placing = [&verb](const char* name, auto& values, const char* type, const char* help) {
    constexpr const char* kGroup = "Placing models (each repeatable, in the order of the models)";
    verb.option(name, values, help, {.type = type, .group = kGroup});
  };
  verb.option("INPUT", arguments.inputs, "SCENE.json, or one glTF file per instance: MODEL.glb ...",
              {.is_required = needed == InputsNeeded::one});
  placing("--clip", arguments.clips, "NAME",
          "Animation clip, played in a loop; \"\": the unnamed clip; -: the default pose; '*': all "
          "clips of the model, one after the other; the other models start again with each clip");
  placing("--start", arguments.starts, "SECONDS", "Time in the clip at frame 0");
  placing("--at", arguments.positions, "X,Y,Z", "Position");
  placing("--turn", arguments.turns, "DEGREES", "Rotation about the y axis, which points up");
  placing("--scale", arguments.scales, "FACTOR", "Uniform scale");
  verb.option(
      "--fps", arguments.fps,
      "Frames per second: frame f is at f / FPS seconds (default: that of the scene, or 30)",
      {.type = "FPS"});
  add_model_options(verb, arguments.models);
}

bool asks_for_scene(const SceneArguments& arguments) {
  return arguments.inputs.size() == 1 && is_scene_file(arguments.inputs[0]);
}

Result<void> check_fps(const std::optional<double>& fps) {
  if (!fps || (*fps >= scenes::kMinFps && *fps <= scenes::kMaxFps)) return {};
  return text::number_not_allowed("--fps", *fps, "give a number from 1e-6 to 1e6");
}

Result<Scene> open_scene(const SceneArguments& arguments) {
  if (const auto checked = check_fps(arguments.fps); !checked) return checked.error();
  return asks_for_scene(arguments) ? scene_of_file(arguments) : scene_of_models(arguments);
}

Result<FrameRange> choose_frames(const std::string& text, const SceneArguments& arguments,
                                 Scene& scene) {
  if (text.empty()) return FrameRange{0, scene.frame_count};
  Result<FrameRange> range = parse_frame_range(text);
  if (!range) return range;
  const bool loops = !asks_for_scene(arguments) && scene.takes.empty();
  if (loops && range->end <= scenes::kMaxFrames) {
    if (range->end > scene.frame_count && !plays_nothing(scene))
      scene.notes.push_back(loop_note(scene));
    scene.frame_count = std::max(scene.frame_count, range->end);
    if (range->frames().size() > 1 && plays_nothing(scene))
      scene.notes.push_back(
          "nothing moves, so all frames are the same: select clips with --clip, or leave out "
          "--frames");
  }
  if (range->end <= scene.frame_count) return range;
  return text::bad_argument("--frames", text + " goes beyond the last frame",
                            scene.name + " has frames 0:" + std::to_string(scene.frame_count));
}

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

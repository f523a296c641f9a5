/// Compares Pelt with other libraries on scenes, in the steps between the frames of scenes, and on
/// characters against themselves; prints a table and writes a CSV file.

#include "evaluation/peers/moving_peer_figures.hpp"
#include "evaluation/peers/peer_figures.hpp"
#include "text/message.hpp"
#include "tools/pelt/arguments/scene_arguments.hpp"
#include "tools/pelt/arguments/values.hpp"
#include "tools/pelt/output/output_conflicts.hpp"
#include "tools/pelt/output/output_file.hpp"
#include "tools/pelt/output/process.hpp"
#include "tools/pelt/output/progress.hpp"

#include <CLI/CLI.hpp>

#include <iostream>
#include <string>

namespace pelt::tools {
namespace {

struct Arguments {
  std::vector<std::string> inputs, clips;
  bool is_self = false, is_moving = false;
  std::string frames, csv;
  std::uint32_t repetitions = 5;
};

Result<std::vector<std::uint32_t>> chosen_frames(const std::string& text,
                                                 const scenes::Scene& scene) {
  if (text.empty()) return arguments::FrameRange{0, scene.frame_count}.frames();
  const Result<arguments::FrameRange> range = arguments::parse_frame_range(text);
  if (!range) return range.error();
  if (range->end <= scene.frame_count) return range->frames();
  return text::bad_argument("--frames", text + " goes beyond the last frame",
                            scene.name + " has frames 0:" + std::to_string(scene.frame_count));
}

Result<ScenePeers> measure_input(const Arguments& arguments, std::size_t i) {
  arguments::SceneArguments alone;
  alone.inputs = {arguments.inputs[i]};
  if (i < arguments.clips.size()) alone.clips = {arguments.clips[i]};
  Result<scenes::Scene> scene = arguments::open_scene(alone);
  if (!scene) return scene.error();
  const bool is_model = !arguments::asks_for_scene(alone);
  if (is_model) scene->name = alone.inputs[0];
  const Contest contest = is_model || arguments.is_self ? Contest::self : Contest::pairs;
  const auto frames = chosen_frames(arguments.frames, *scene);
  if (!frames) return frames.error();
  arguments::ModelArguments models;
  models.renormalise = true;
  const auto colliders = scene::make_colliders(*scene, scene::Granularity::instance, models);
  if (!colliders) return colliders.error();
  output::Progress progress(peer_steps(frames->size(), contest));
  return measure_peers(
      {*scene, *colliders, *frames}, arguments.repetitions, [&] { progress.advance(); }, contest);
}

Result<MovingScenePeers> measure_steps(const Arguments& arguments, const std::string& input) {
  arguments::SceneArguments alone;
  alone.inputs = {input};
  const Result<scenes::Scene> scene = arguments::open_scene(alone);
  if (!scene) return scene.error();
  std::optional<arguments::FrameRange> frames;
  if (!arguments.frames.empty()) {
    const auto range = arguments::parse_frame_range(arguments.frames);
    if (!range) return range.error();
    frames = *range;
  }
  const auto steps = lab::choose_steps(*scene, frames);
  if (!steps) return steps.error();
  const auto colliders = scene::make_colliders(*scene, scene::Granularity::instance, {});
  if (!colliders) return colliders.error();
  return measure_moving_peers({*scene, *colliders, *steps}, arguments.repetitions);
}

int fail(const std::string& message) {
  std::cerr << "peer_table: " << message << '\n';
  return 1;
}

Result<void> check_csv(const Arguments& arguments) {
  std::vector<output::InputFile> inputs;
  for (const std::string& input : arguments.inputs) inputs.push_back({input, "the input " + input});
  const output::NamedOutput csv = {"--csv", arguments.csv};
  return output::check_outputs({&csv, 1}, inputs);
}

int run_moving(const Arguments& arguments) {
  if (arguments.is_self || !arguments.csv.empty())
    return fail("--moving cannot be combined with --self or --csv");
  for (const std::string& input : arguments.inputs) {
    const Result<MovingScenePeers> scene = measure_steps(arguments, input);
    if (!scene) return fail(scene.error().message);
    print_moving_peers(*scene, std::cout);
  }
  return 0;
}

int run(const Arguments& arguments) {
  if (arguments.is_moving) return run_moving(arguments);
  if (const auto checked = check_csv(arguments); !checked) return fail(checked.error().message);
  output::OutputFile csv;
  if (const auto opened = csv.open(arguments.csv); !opened) return fail(opened.error().message);
  std::vector<ScenePeers> scenes;
  for (std::size_t i = 0; i < arguments.inputs.size(); ++i) {
    const Result<ScenePeers> scene = measure_input(arguments, i);
    if (!scene) return fail(scene.error().message);
    print_peers(*scene, std::cout);
    scenes.push_back(*scene);
  }
  if (csv.stream() != nullptr) write_peers_csv(scenes, *csv.stream());
  const Result<void> written = csv.close();
  return written ? 0 : fail(written.error().message);
}

int parse_and_run(int argc, char** argv) {
  CLI::App app("Compare times and answers of other libraries with those of Pelt on scenes");
  Arguments arguments;
  app.add_option("INPUT", arguments.inputs, "Scene files (.json), or models against themselves")
      ->required();
  app.add_option("--clip", arguments.clips, "Clip of a model, in the order of the models")
      ->allow_extra_args(false);
  app.add_flag("--self", arguments.is_self, "Each instance of a scene against itself");
  app.add_flag("--moving", arguments.is_moving, "Steps between the frames of scenes");
  app.add_option("--frames", arguments.frames, "A:B or A:B:STEP; all frames");
  app.add_option("--repetitions", arguments.repetitions, "The median of so many counts")
      ->capture_default_str()
      ->check(CLI::PositiveNumber);
  app.add_option("--csv", arguments.csv, "Write the table")->type_name("FILE");
  CLI11_PARSE(app, argc, argv);
  output::remove_unfinished_files_on_signals();
  return run(arguments);
}

}  // namespace
}  // namespace pelt::tools

int main(int argc, char** argv) { return pelt::tools::parse_and_run(argc, argv); }

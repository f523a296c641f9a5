/// `pelt bench`: what every method costs on a scene. No time is shown before all methods have given
/// the same answer.

#include "asset/message.hpp"
#include "scenes/nearest_name.hpp"
#include "tools/pelt/bench_report.hpp"
#include "tools/pelt/commands.hpp"
#include "tools/pelt/model_arguments.hpp"
#include "tools/pelt/output.hpp"
#include "tools/pelt/progress.hpp"
#include "tools/pelt/text.hpp"

#include <CLI/CLI.hpp>

#include <chrono>
#include <iostream>

namespace pelt::tools {
namespace {

using bench::MethodKind;

/// The public functions: what the other methods' answers are compared with.
constexpr MethodKind kReference = MethodKind::paper;

struct Arguments {
  std::vector<std::string> scenes;
  std::string json, frames, cache = "hot";
  std::string methods = "paper,paper_eq2,paper_eager";
  bool first = false;
  std::uint32_t repetitions = 9;
  ModelArguments models;
};

constexpr const char* kFooter = R"(
Examples:
  pelt bench scene.json
  pelt bench scene.json --first --methods paper,paper_eager
  pelt bench scene.json --frames 0:60:20 --cache cold --json figures.json

Each repetition of a frame first runs the frame before it, untimed; then the clock runs while the
palettes are set and all pairs are asked. The median of the repetitions stands for the frame; shown
are the mean over all frames, over those in contact, and what 95 % of the frames do not exceed.
"update" is the part before the queries: for paper_eager skinning and refit. Sampling of the clips
is not timed. One thread.)";

struct Choice {
  std::vector<MethodKind> methods;
  BenchSettings settings;
};

Result<std::vector<MethodKind>> parse_methods(const std::string& text) {
  std::vector<MethodKind> methods;
  for (const std::string_view name : split(text, ',')) {
    const auto method = bench::find_method(name);
    if (!method) {
      return Error{ErrorCode::invalid_argument,
                   "--methods: there is no " + asset::quoted(name) +
                       scenes::suggestion(name, bench::method_names())};
    }
    methods.push_back(*method);
  }
  return methods;
}

Result<Choice> choose(const Arguments& arguments) {
  Choice choice;
  const auto methods = parse_methods(arguments.methods);
  if (!methods) return methods.error();
  choice.methods = *methods;
  if (arguments.first) choice.settings.question = Question::first;
  if (arguments.cache != "hot" && arguments.cache != "cold") {
    return bad_argument("--cache", "there is no " + asset::quoted(arguments.cache),
                        "give hot or cold");
  }
  if (arguments.cache == "cold") choice.settings.cache = Cache::cold;
  if (arguments.repetitions == 0) {
    return bad_argument("--repeat", "0 repetitions measure nothing", "give 1 or more");
  }
  choice.settings.repetitions = arguments.repetitions;
  if (arguments.frames.empty()) return choice;
  const auto frames = parse_frame_range(arguments.frames);
  if (!frames) return frames.error();
  choice.settings.frames = *frames;
  return choice;
}

/// A scene ready to be measured.
struct Subject {
  scenes::Scene scene;
  std::vector<Collider> colliders;
  FrameRange frames;
  double build_seconds = 0;
};

Result<Subject> prepare(const std::string& path, const Arguments& arguments,
                        const BenchSettings& settings) {
  Result<scenes::Scene> scene = scenes::load_scene(path, arguments.models.gltf_options());
  if (!scene) return scene.error();
  const FrameRange frames = settings.frames.value_or(FrameRange{0, scene->frame_count});
  if (frames.end > scene->frame_count) {
    return bad_argument("--frames", arguments.frames + " goes beyond the last frame",
                        scene->name + " has frames 0:" + std::to_string(scene->frame_count));
  }
  const auto begin = std::chrono::steady_clock::now();
  auto colliders = make_colliders(*scene, Granularity::instance, arguments.models.model_options());
  if (!colliders) return colliders.error();
  const std::chrono::duration<double> build = std::chrono::steady_clock::now() - begin;
  return Subject{std::move(*scene), std::move(*colliders), frames, build.count()};
}

struct Answers {
  std::uint64_t reference_hash = 0;
  std::vector<EngineFigures> engines;  ///< without times
};

Result<Answers> answer(const Subject& subject, const Choice& choice) {
  const auto answer_by = [&](MethodKind method) {
    return answer_once(subject.scene, subject.colliders, method, subject.frames,
                       choice.settings.question);
  };
  const Result<Measurement> reference = answer_by(kReference);
  if (!reference) return reference.error();
  Answers answers{reference->hash, {}};
  for (const MethodKind method : choice.methods) {
    const Result<Measurement> found = method == kReference ? reference : answer_by(method);
    if (!found) return found.error();
    answers.engines.push_back({std::string(bench::name_of(method)), *found});
  }
  return answers;
}

/// Whether all methods found the same contacts; tells which did not.
bool agree(const Subject& subject, const Answers& answers) {
  for (const EngineFigures& engine : answers.engines) {
    if (engine.measurement.hash == answers.reference_hash) continue;
    std::cerr << "pelt: internal error: " << subject.scene.name << ": " << engine.engine
              << " gives the hash " << hex16(engine.measurement.hash) << ", "
              << bench::name_of(kReference) << " gives " << hex16(answers.reference_hash)
              << ": please report this with the scene\n";
    return false;
  }
  return true;
}

Result<void> measure_all(const Subject& subject, const Choice& choice,
                         std::vector<EngineFigures>& engines) {
  Progress progress(subject.frames.frames().size() * choice.methods.size());
  for (std::size_t m = 0; m < choice.methods.size(); ++m) {
    const auto measured = measure(
        subject.scene, subject.colliders, choice.methods[m], subject.frames, choice.settings,
        [&] { progress.advance(); }, engines[m].measurement);
    if (!measured) return measured.error();
  }
  return {};
}

/// Appends to `scenes` unless the methods disagree.
Result<ExitCode> bench_scene(const std::string& path, const Arguments& arguments,
                             const Choice& choice, std::vector<SceneFigures>& scenes) {
  const Result<Subject> subject = prepare(path, arguments, choice.settings);
  if (!subject) return subject.error();
  Result<Answers> answers = answer(*subject, choice);
  if (!answers) return answers.error();
  if (!agree(*subject, *answers)) return ExitCode::internal;
  const auto measured = measure_all(*subject, choice, answers->engines);
  if (!measured) return measured.error();
  SceneFigures& figures = scenes.emplace_back();
  figures.scene = subject->scene.name;
  figures.build_seconds = subject->build_seconds;
  figures.engines = std::move(answers->engines);
  for (const Collider& collider : subject->colliders) {
    figures.triangles += collider.model.triangle_count();
  }
  print_figures(figures, choice.settings, std::cout);
  return ExitCode::success;
}

Result<ExitCode> bench_scenes(const Arguments& arguments) {
  const Result<Choice> choice = choose(arguments);
  if (!choice) return choice.error();
  std::vector<SceneFigures> scenes;
  for (const std::string& path : arguments.scenes) {
    const Result<ExitCode> exit = bench_scene(path, arguments, *choice, scenes);
    if (!exit || *exit != ExitCode::success) return exit;
  }
  if (arguments.json.empty()) return ExitCode::success;
  const std::string text = figures_json(scenes, choice->settings).dump(2) + "\n";
  const auto written = write_file(arguments.json, std::as_bytes(std::span(text)));
  if (!written) return written.error();
  return ExitCode::success;
}

}  // namespace

void add_bench(CLI::App& app, Command& chosen) {
  CLI::App* verb = app.add_subcommand("bench", "Measure every method on scenes");
  const auto arguments = std::make_shared<Arguments>();
  verb->add_option("SCENE", arguments->scenes, "Scene files")->required();
  verb->add_option(
          "--methods", arguments->methods,
          "Methods, with commas between them; paper_rigid builds trees in every repetition")
      ->type_name("A,B")
      ->capture_default_str();
  verb->add_flag("--first", arguments->first, "Ask only whether each pair touches");
  verb->add_option("--cache", arguments->cache, "cold: 64 MB are read before the clock starts")
      ->type_name("hot|cold")
      ->capture_default_str();
  verb->add_option("--repeat", arguments->repetitions, "Repetitions of each frame")
      ->type_name("N")
      ->capture_default_str();
  verb->add_option("--frames", arguments->frames, "Frames A to B - 1, each S-th of them")
      ->type_name("A:B[:S]");
  verb->add_option("--json", arguments->json, "Write the figures")->type_name("FILE");
  add_model_options(*verb, arguments->models);
  verb->footer(kFooter);
  verb->callback(
      [arguments, &chosen] { chosen = [arguments] { return bench_scenes(*arguments); }; });
}

}  // namespace pelt::tools

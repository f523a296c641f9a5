/// `pelt bench`: the cost of each method on a scene, in the steps between its frames, or on a
/// character against itself. Prints no time unless all methods give the same answer.

#include "asset/message.hpp"
#include "asset/printable.hpp"
#include "scenes/closest_name.hpp"
#include "tools/pelt/arguments/input_files.hpp"
#include "tools/pelt/arguments/scene_arguments.hpp"
#include "tools/pelt/arguments/simd_argument.hpp"
#include "tools/pelt/arguments/verb.hpp"
#include "tools/pelt/bench/bench_against.hpp"
#include "tools/pelt/bench/bench_moving.hpp"
#include "tools/pelt/bench/bench_scene.hpp"
#include "tools/pelt/methods/command_methods.hpp"
#include "tools/pelt/output/output.hpp"
#include "tools/pelt/output/output_conflicts.hpp"
#include "tools/pelt/output/output_file.hpp"
#include "tools/pelt/output/text.hpp"
#include "tools/pelt/verbs/commands.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <iostream>

namespace pelt::tools::verbs {
namespace {

constexpr const char *kAllQueries = "all,first", *kAllCaches = "hot,cold";

struct Arguments {
  std::string program;
  std::vector<std::string> inputs, clips;
  bool is_self = false, is_moving = false;
  std::optional<double> fps;
  BenchMethods known;
  std::string methods;
  std::string queries = kAllQueries, caches = kAllCaches;
  std::string threads, json, against, frames, simd;
  std::optional<std::uint32_t> margin;
  std::uint32_t repetitions = bench::kEnoughRepetitions;
  arguments::ModelArguments models;
};

constexpr const char* kFooter = R"(
Examples:
  pelt bench scene.json
  pelt bench scene.json --methods on_demand,eager --queries first --caches hot
  pelt bench scene.json --frames 0:60:20 --repeat 15 --json figures.json
  pelt bench scene.json --frames 0:60:20 --against figures.json
  pelt bench scene.json --methods eager,on_demand --threads 1,2
  pelt bench knight.glb --clip Walk
  pelt bench scene.json --self
  pelt bench scene.json --moving

Each repetition of a frame first runs the previous frame untimed (for the first frame, the last one),
then times setting the palettes and querying all pairs. The time of a frame is the median of its
repetitions; fewer than 9 give a rough measurement. The columns show the mean over all frames, the
mean over the frames in contact, and the 95th percentile. "update" is the time before the queries:
setting the palettes and, for methods that skin all vertices, skinning and refitting. Computing joint
matrices from clips is not timed. "vs paper" and "vs eager" are speed-ups over these methods. With cold
caches, 64 MB are read before each measurement, and at most 30 evenly spaced frames are measured. The
methods take turns at every frame.

Pairs are queried one by one on one thread, in thread time, which excludes pauses in which the system
runs other programs. With --threads, on_demand runs as a crowd instead, once for each of these numbers
of threads. The threads share the work of querying pairs. Setting the palettes uses one thread for
every 64 palettes. All times of that run are wall times. "vs 1 thread" is the speed-up over a crowd on
one thread.

A model is queried against itself; with --self, so is each instance of a scene. self finds all contacts
that pelt check finds without filters (--self-rings 0, and keep for the others). brute tests all pairs
of triangles. boxes skins all vertices and computes all boxes, and finds nothing. "of boxes" is the cost
of a method over that of boxes. "vs all" is the speed-up of the query first over the query all. The line
"frames in order" compares self with a SelfTracker, while the frames are played in order.

--moving measures the queries between frames, for each step from a frame of --frames to the next:
pairs: which triangles touch during the step; times: the same with times and features; first: the
first contact of each pair of instances; touch: whether each pair touches. collide is the discrete
query at the end of the step. Each repetition first queries the step before, untimed. "update"
computes one end of the step, because the other is the end of the step before. "of collide" and "of
on_demand" are the cost over that of on_demand for collide and for the same query. All hashes must be
those of brute, which decides every pair of triangles whose extents overlap, without a tree. The last
table shows which share of the pairs of triangles each arithmetic decides.

--against compares with FILE. The last tables show, for each scene, query and cache, the speed-up of a
method over paper and eager, or its cost over boxes: then (in FILE), now, and now/then. "worse" marks a
ratio that has become worse by more than --margin. Ratios differ little between machines, but they are
noisy: on a loaded machine, 1 in 14 speed-ups of an unchanged build was marked at 15 %, so repeat a
measurement that looks worse. If a method has lost speed-up over paper, but not over eager, then paper
has become faster, and vice versa. The output lists what is missing from FILE. A slower method is not a
failure. An answer that differs from FILE is a failure, with exit code 3.

--json writes {"format": "pelt-bench", "version": 1, "machine": {...}, "scenes": [...]}:
  machine    cpu, cores, instruction_set, compiler, build, flags, pelt (version)
  scenes     scene (file), frames, frames_in_contact, repetitions, time (thread or wall)
    models   triangles, bytes, build_seconds: totals, counting each model once; with --self also
             self_filter_bytes, self_filter_build_seconds
    skinning vertices (of all instances), mean_us, ns_per_vertex
    sequence self_us, tracked_us: frames played in order, without and with a SelfTracker; with --self
    methods  method, query, cache, asked (pairs, crowd, self or none), threads, frames
             (timed frames), mean_us, mean_contact_us (null without contact), p95_us, mean_update_us, hash
    counters of a method over all frames: node_pairs, refits, posed_vertices, triangle_pairs, displacements
With --moving, the format is "pelt-bench-moving"; scenes have triangles, steps, repetitions, skinning
and methods, and methods have method, query, mean_us, median_us, mean_contact_us, p95_us,
mean_update_us, of_collide, ns_per_pair (null for collide, first and touch), steps_in_contact, contacts, hash and counters, with
double_pairs and exact_pairs: pairs of triangles that were not decided in float, or not in double.
Names that end in _us are microseconds per frame or step. pelt(1) describes each field, with an example.)";

/// A larger number is probably a typing error.
constexpr std::uint32_t kMaxThreads = 256;

constexpr std::array kQuestions = {bench::Question::all, bench::Question::first};
constexpr std::array kCaches = {bench::Cache::hot, bench::Cache::cold};

/// Parses a list like "hot,cold" into values; `names` has the names of all `values`.
template <typename T>
Result<std::vector<T>> parse_list(const char* option, const std::string& text,
                                  std::span<const T> values,
                                  std::span<const std::string_view> names) {
  std::vector<T> parsed;
  for (const std::string_view name : output::split(text, ',')) {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) {
      return Error{ErrorCode::invalid_argument, std::string(option) + ": unknown value " +
                                                    asset::quoted(name) +
                                                    scenes::suggestion(name, names)};
    }
    const T value = values[static_cast<std::size_t>(found - names.begin())];
    if (std::find(parsed.begin(), parsed.end(), value) == parsed.end()) parsed.push_back(value);
  }
  return parsed;
}

template <typename T, std::size_t kCount>
Result<std::vector<T>> parse_list(const char* option, const std::string& text,
                                  const std::array<T, kCount>& values) {
  std::array<std::string_view, kCount> names;
  for (std::size_t i = 0; i < kCount; ++i) names[i] = name_of(values[i]);
  return parse_list<T>(option, text, values, names);
}

Result<std::vector<methods::MethodKind>> parse_methods(const Arguments& arguments) {
  const auto& [known, measured] = arguments.is_self ? arguments.known.self : arguments.known.pairs;
  const std::string& names = arguments.methods.empty() ? measured : arguments.methods;
  return parse_list<methods::MethodKind>("--methods", names, known, methods::names_of(known));
}

/// Parses numbers of threads; none if the text is empty.
Result<std::vector<std::uint32_t>> parse_threads(const std::string& text) {
  std::vector<std::uint32_t> counts;
  if (text.empty()) return counts;
  for (const std::string_view word : output::split(text, ',')) {
    std::uint32_t count = 0;
    if (!output::parse_whole(word, count) || count == 0 || count > kMaxThreads) {
      return output::bad_argument(
          "--threads", asset::quoted(word) + " is not a number of threads",
          "give numbers from 1 to " + std::to_string(kMaxThreads) + " with commas between them");
    }
    if (std::find(counts.begin(), counts.end(), count) == counts.end()) counts.push_back(count);
  }
  return counts;
}

Result<std::vector<bench::BenchMethod>> choose_methods(const Arguments& arguments) {
  const auto kinds = parse_methods(arguments);
  if (!kinds) return kinds.error();
  const auto threads = parse_threads(arguments.threads);
  if (!threads) return threads.error();
  std::vector<bench::BenchMethod> methods;
  for (const methods::MethodKind& method : *kinds) {
    if (arguments.is_self)
      methods.push_back(bench::self_method(method));
    else if (method != methods::kOnDemand || threads->empty())
      methods.push_back(bench::method_of(method));
    else
      for (const std::uint32_t count : *threads) methods.push_back(bench::crowd_method(count));
  }
  if (!threads->empty() && bench::time_of(methods) == bench::Time::thread) {
    return output::bad_argument(
        "--threads", "only the method on_demand for pairs of instances supports several threads",
        "add on_demand to --methods, or leave out --threads");
  }
  return methods;
}

Result<bench::BenchSettings> choose(const Arguments& arguments) {
  bench::BenchSettings settings;
  settings.is_self = arguments.is_self;
  const auto methods = choose_methods(arguments);
  if (!methods) return methods.error();
  settings.methods = *methods;
  const auto questions = parse_list("--queries", arguments.queries, kQuestions);
  if (!questions) return questions.error();
  settings.questions = *questions;
  const auto caches = parse_list("--caches", arguments.caches, kCaches);
  if (!caches) return caches.error();
  settings.caches = *caches;
  settings.repetitions = arguments.repetitions;
  settings.models = arguments.models;
  settings.program = arguments.program;
  if (arguments.frames.empty()) return settings;
  const auto frames = arguments::parse_frame_range(arguments.frames);
  if (!frames) return frames.error();
  settings.frames = *frames;
  return settings;
}

/// Returns an error if an option was given that --moving does not have.
Result<void> check_moving(const Arguments& arguments) {
  const std::pair<bool, const char*> others[] = {{arguments.is_self, "--self"},
                                                 {arguments.queries != kAllQueries, "--queries"},
                                                 {arguments.caches != kAllCaches, "--caches"},
                                                 {!arguments.threads.empty(), "--threads"},
                                                 {!arguments.against.empty(), "--against"},
                                                 {arguments.margin.has_value(), "--margin"}};
  for (const auto& [is_given, option] : others)
    if (is_given)
      return output::bad_argument("--moving", "cannot be combined with " + std::string(option),
                                  "leave out one of them");
  return {};
}

Result<bench::MovingSettings> choose_moving(const Arguments& arguments) {
  const auto& [known, measured] = arguments.known.moving;
  std::vector<std::string_view> names;
  for (const methods::MovingMethodKind& kind : known) names.push_back(kind.name);
  const auto kinds = parse_list<methods::MovingMethodKind>(
      "--methods", arguments.methods.empty() ? measured : arguments.methods, known, names);
  if (!kinds) return kinds.error();
  bench::MovingSettings settings;
  for (const methods::MovingMethodKind& kind : *kinds)
    settings.methods.push_back(bench::moving_method_of(kind));
  settings.program = arguments.program;
  settings.repetitions = arguments.repetitions;
  settings.models = arguments.models;
  if (arguments.frames.empty()) return settings;
  const auto frames = arguments::parse_frame_range(arguments.frames);
  if (!frames) return frames.error();
  settings.frames = *frames;
  return settings;
}

/// The command line of input `i` alone.
arguments::SceneArguments input_alone(const Arguments& arguments, std::size_t i) {
  arguments::SceneArguments alone;
  alone.inputs = {arguments.inputs[i]};
  if (i < arguments.clips.size()) alone.clips = {arguments.clips[i]};
  alone.fps = arguments.fps;
  alone.models = arguments.models;
  return alone;
}

/// Loads an input. The name tells inputs with different answers apart.
Result<scenes::Scene> load_input(const Arguments& arguments, std::size_t i) {
  const arguments::SceneArguments alone = input_alone(arguments, i);
  Result<scenes::Scene> scene = arguments::open_scene(alone);
  if (!scene || !arguments.is_self) return scene;
  scene->name = std::filesystem::path(alone.inputs[0]).filename().string();
  for (const std::string& clip : alone.clips) scene->name += " " + clip;
  if (arguments::asks_for_scene(alone)) scene->name += " --self";
  return scene;
}

Result<arguments::ExitCode> bench_input(const Arguments& arguments, std::size_t i,
                                        const bench::BenchSettings& settings,
                                        std::vector<bench::SceneFigures>& figures,
                                        std::ostream& words) {
  const auto scene = load_input(arguments, i);
  if (!scene) return scene.error();
  for (const std::string& note : scene->notes) words << "note: " << note << '\n';
  const Result<arguments::ExitCode> exit = bench::bench_scene(*scene, settings, figures, std::cerr);
  if (!exit || *exit != arguments::ExitCode::success) return exit;
  if (figures.size() == 1) bench::print_machine(words);
  bench::print_figures(figures.back(), words);
  return exit;
}

/// Nullopt without --against.
Result<std::optional<bench::Baseline>> choose_baseline(const Arguments& arguments) {
  if (arguments.against.empty() && arguments.margin)
    return output::bad_argument("--margin", "requires --against",
                                "name the file with --against FILE");
  if (arguments.against.empty()) return std::optional<bench::Baseline>();
  auto baseline = bench::read_baseline(arguments.against);
  if (!baseline) return baseline.error();
  return std::optional<bench::Baseline>(std::move(*baseline));
}

arguments::ExitCode compare(const bench::Baseline& baseline, const Arguments& arguments,
                            std::span<const bench::SceneFigures> figures, std::ostream& words) {
  const bench::BenchComparison comparison = bench::print_comparison(
      baseline, figures, arguments.margin.value_or(bench::kNoisePercent), words);
  if (comparison.different_answers == 0) return arguments::ExitCode::success;
  std::cerr
      << arguments.program << ": error: " << output::counted(comparison.different_answers, "answer")
      << " different from " << asset::printable(baseline.path)
      << ": if scenes, characters and options are the same, please report this; if the answers "
         "should differ, write a new file with --json\n";
  return arguments::ExitCode::internal;
}

/// Loads the inputs a second time, because the check needs the names of their models before they
/// are measured.
Result<void> check_output(const Arguments& arguments) {
  if (arguments.json.empty() && !output::is_standard_output_a_file()) return {};
  std::vector<output::InputFile> inputs;
  if (!arguments.against.empty())
    inputs.push_back({arguments.against, "what --against compares with"});
  for (std::size_t i = 0; i < arguments.inputs.size(); ++i) {
    const auto scene = load_input(arguments, i);
    if (!scene) return scene.error();
    for (output::InputFile& file : arguments::files_of_scene(input_alone(arguments, i), *scene))
      inputs.push_back(std::move(file));
  }
  const output::NamedOutput output = {"--json", arguments.json};
  return output::check_outputs({&output, 1}, inputs);
}

bool is_scene_file(const std::string& path) {
  return std::filesystem::path(path).extension() == ".json";
}

/// Whether all inputs are models, which can only be queried against themselves. Scenes and models
/// have different methods and tables, so a run has only one of the two, unless --self is given.
Result<bool> has_only_models(const Arguments& arguments) {
  const auto scenes =
      std::count_if(arguments.inputs.begin(), arguments.inputs.end(), is_scene_file);
  if (scenes == 0) return true;
  if (!arguments.clips.empty())
    return output::bad_argument("--clip", "applies to models, not to a scene file",
                                "edit the scene file instead");
  if (arguments.is_self || scenes == std::ssize(arguments.inputs)) return false;
  return output::bad_argument("INPUT", "scenes and models cannot be measured in one run",
                              "add --self, or start a run for each");
}

/// Opens the file of --json. Does nothing without --json.
Result<void> open_json(const Arguments& arguments, output::OutputFile& json) {
  if (const auto checked = check_output(arguments); !checked) return checked;
  return json.open(arguments.json);
}

/// Does nothing without --json.
Result<void> write_json(const Arguments& arguments, const std::string& text,
                        output::OutputFile& json, std::ostream& words) {
  if (arguments.json.empty()) return {};
  const auto written = json.write_and_close(std::as_bytes(std::span(text)));
  if (written) output::print_written(arguments.json, words);
  return written;
}

Result<arguments::ExitCode> bench_steps(const Arguments& arguments) {
  if (const auto checked = check_moving(arguments); !checked) return checked.error();
  const Result<bench::MovingSettings> settings = choose_moving(arguments);
  if (!settings) return settings.error();
  output::OutputFile json;
  if (const auto opened = open_json(arguments, json); !opened) return opened.error();
  std::ostream& words = output::words_beside({arguments.json});
  std::vector<bench::MovingSceneFigures> figures;
  for (std::size_t i = 0; i < arguments.inputs.size(); ++i) {
    const auto scene = load_input(arguments, i);
    if (!scene) return scene.error();
    for (const std::string& note : scene->notes) words << "note: " << note << '\n';
    const auto exit = bench::bench_moving(*scene, *settings, figures, std::cerr);
    if (!exit || *exit != arguments::ExitCode::success) return exit;
    if (figures.size() == 1) bench::print_machine(words);
    bench::print_moving_figures(figures.back(), words);
  }
  const auto written = write_json(arguments, bench::moving_figures_json(figures), json, words);
  if (!written) return written.error();
  return arguments::ExitCode::success;
}

Result<arguments::ExitCode> bench_inputs(Arguments arguments) {
  const Result<bool> only_models = has_only_models(arguments);
  if (!only_models) return only_models.error();
  arguments.is_self = arguments.is_self || *only_models;
  if (arguments.clips.size() > arguments.inputs.size())
    return output::bad_argument("--clip", "was given more often than there are models",
                                "give it at most once per model, in the order of the models");
  if (const auto chosen = arguments::choose_simd(arguments.simd); !chosen) return chosen.error();
  if (arguments.is_moving && *only_models)
    return output::bad_argument("--moving", "requires scene files", "write a scene of the models");
  if (arguments.is_moving) return bench_steps(arguments);
  const Result<bench::BenchSettings> settings = choose(arguments);
  if (!settings) return settings.error();
  const auto baseline = choose_baseline(arguments);
  if (!baseline) return baseline.error();
  output::OutputFile json;
  if (const auto opened = open_json(arguments, json); !opened) return opened.error();
  std::ostream& words = output::words_beside({arguments.json});
  std::vector<bench::SceneFigures> figures;
  for (std::size_t i = 0; i < arguments.inputs.size(); ++i) {
    const Result<arguments::ExitCode> exit = bench_input(arguments, i, *settings, figures, words);
    if (!exit || *exit != arguments::ExitCode::success) return exit;
  }
  const auto written = write_json(arguments, bench::figures_json(figures), json, words);
  if (!written) return written.error();
  return *baseline ? compare(**baseline, arguments, figures, words) : arguments::ExitCode::success;
}

std::string listed(methods::MovingMethodKinds kinds) {
  std::string list;
  for (const methods::MovingMethodKind& kind : kinds)
    list.append(list.empty() ? "" : ", ").append(kind.name);
  return list;
}

std::string help_on_methods(const BenchMethods& known) {
  return "Methods to measure, separated by commas, of " + methods::listed(known.pairs.known) +
         " (default: " + known.pairs.measured + "); with --self, of " +
         methods::listed(known.self.known) + " (default: " + known.self.measured +
         "); with --moving, of " + listed(known.moving.known) +
         " (default: " + known.moving.measured + ")";
}

void add_options(arguments::Verb& verb, Arguments& arguments) {
  verb.option("INPUT", arguments.inputs, "Scene files, or models to query against themselves",
              {.is_required = true});
  verb.option("--clip", arguments.clips,
              "Animation clip of a model, repeatable, in the order of the models; '*': all clips",
              {.type = "NAME"});
  verb.option("--fps", arguments.fps,
              "Frames per second of clips (default: that of the scene, or 30)", {.type = "FPS"});
  verb.flag("--self", arguments.is_self, "Query each instance of a scene against itself");
  verb.flag("--moving", arguments.is_moving, "Query the steps between the frames of scenes");
  verb.option("--methods", arguments.methods, help_on_methods(arguments.known), {.type = "A,B"});
  verb.option("--queries", arguments.queries,
              "all: every contact; first: only whether each pair touches", {.type = "all,first"});
  verb.option("--caches", arguments.caches, "hot: as the previous frame left them; cold: emptied",
              {.type = "hot,cold"});
  verb.option("--threads", arguments.threads,
              "Run on_demand as a crowd on N threads, on M threads, ...", {.type = "N,M"});
  verb.option("--repeat", arguments.repetitions, "Repetitions of each frame",
              {.type = "N", .least = 1});
  verb.option("--frames", arguments.frames, "Frames A to B - 1, each S-th of them",
              {.type = "A:B[:S]"});
  verb.option("--json", arguments.json, "Write the figures", {.type = "FILE"});
  verb.option("--against", arguments.against, "Compare with figures that --json has written",
              {.type = "FILE"});
  verb.option("--margin", arguments.margin,
              "Mark ratios that have become worse by more than PERCENT per cent (default: " +
                  std::to_string(bench::kNoisePercent) + ")",
              {.type = "PERCENT", .most = 1000});
  arguments::add_simd_option(verb, arguments.simd);
  arguments::add_model_options(verb, arguments.models);
}

}  // namespace

void add_bench(CLI::App& app, arguments::Command& chosen, const BenchMethods& methods) {
  arguments::Verb verb(app, "bench", "Measure the speed of methods on scenes and characters",
                       (kFooter + methods.notes).c_str());
  const auto arguments = std::make_shared<Arguments>();
  arguments->program = verb.program();
  arguments->known = methods;
  add_options(verb, *arguments);
  verb.runs([arguments] { return bench_inputs(*arguments); }, chosen);
}

}  // namespace pelt::tools::verbs

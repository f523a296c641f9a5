/// `pelt bench`: the cost of each method on a scene, in the steps between its frames, or on a
/// character against itself; and what a search knows when it is stopped. Prints no time unless all
/// methods give the same answer.

#include "asset/message.hpp"
#include "asset/printable.hpp"
#include "scenes/closest_name.hpp"
#include "tools/pelt/arguments/input_files.hpp"
#include "tools/pelt/arguments/scene_arguments.hpp"
#include "tools/pelt/arguments/simd_argument.hpp"
#include "tools/pelt/arguments/verb.hpp"
#include "tools/pelt/bench/anytime_chart.hpp"
#include "tools/pelt/bench/anytime_report.hpp"
#include "tools/pelt/bench/bench_against.hpp"
#include "tools/pelt/bench/bench_anytime.hpp"
#include "tools/pelt/bench/bench_moving.hpp"
#include "tools/pelt/bench/bench_scene.hpp"
#include "tools/pelt/bench/moving_against.hpp"
#include "tools/pelt/methods/anytime_methods.hpp"
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
  bool is_self = false, is_moving = false, is_anytime = false;
  std::optional<double> fps;
  BenchMethods known;
  std::string methods;
  std::string queries = kAllQueries, caches = kAllCaches;
  std::string threads, json, svg, against, frames, simd;
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
  pelt bench scene.json --anytime --frames 20:40:5 --svg anytime.svg

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

--anytime measures what a CollisionSearch knows when it is stopped, for each pair of instances that is
in contact in a frame, and prints means over the pairs: the share of the contacts that are listed, the
share of the pairs of triangles that are undecided, and the longest side of an open region, after 1 to
100 % of the work. contacts, resolution and first_contact are the orders of the search; paper is the
paper's sphere tree, refitted on demand, one level after the other. Each method is first run to its end
in 200 equal slices of its work, which is counted and the same on every machine. Then the time of each
share is measured: both instances are posed anew, untimed, and a new search runs to that share. Times are
relative to a complete search of the same pair in the order contacts. "area" is the area below contacts
listed over the work: 1 if all contacts are listed at once, 0 if all are listed at the end. The tables
"after the same time" stop all methods at the same time. "longest step" is what advance may exceed its
work by. Complete searches must find the contacts of collide. --svg draws all this over time.

--against compares with FILE. The last tables show, for each scene, query and cache, the speed-up of a
method over paper and eager, or its cost over boxes: then (in FILE), now, and now/then. "worse" marks a
ratio that has become worse by more than --margin. Ratios differ little between machines, but they are
noisy: on a loaded machine, 1 in 14 speed-ups of an unchanged build was marked at 15 %, so repeat a
measurement that looks worse. If a method has lost speed-up over paper, but not over eager, then paper
has become faster, and vice versa. The output lists what is missing from FILE. A slower method is not a
failure. An answer that differs from FILE is a failure, with exit code 3. With --moving, FILE must be
written with --moving, and the ratios are "of collide" and "of on_demand".

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
With --anytime, the format is "pelt-bench-anytime"; scenes have triangles, frames_in_contact, pairs,
contacts, hash, repetitions, collide_us and methods, and methods have method, work, longest_step,
mean_us, area_over_work, area_over_time, over_work, over_time and course: what is known after shares of
the work, of the time, and at many times, with share, time, listed, undecided and resolution.
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

/// Nullopt without --frames.
Result<std::optional<arguments::FrameRange>> parse_frames(const Arguments& arguments) {
  if (arguments.frames.empty()) return std::optional<arguments::FrameRange>();
  const auto frames = arguments::parse_frame_range(arguments.frames);
  if (!frames) return frames.error();
  return std::optional(*frames);
}

/// Sets what all modes have in common.
template <typename Settings>
Result<void> set_common(const Arguments& arguments, Settings& settings) {
  settings.program = arguments.program;
  settings.repetitions = arguments.repetitions;
  settings.models = arguments.models;
  const auto frames = parse_frames(arguments);
  if (!frames) return frames.error();
  settings.frames = *frames;
  return {};
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
  if (const auto set = set_common(arguments, settings); !set) return set.error();
  return settings;
}

/// Returns an error if an option was given that cannot be combined with `mode`, which is --moving
/// or --anytime.
Result<void> check_alone(const char* mode, const Arguments& arguments) {
  const std::pair<bool, const char*> others[] = {
      {arguments.is_self, "--self"},
      {arguments.is_moving && arguments.is_anytime, "--moving"},
      {arguments.queries != kAllQueries, "--queries"},
      {arguments.caches != kAllCaches, "--caches"},
      {!arguments.threads.empty(), "--threads"},
      {arguments.is_anytime && !arguments.against.empty(), "--against"},
      {arguments.is_anytime && arguments.margin.has_value(), "--margin"}};
  for (const auto& [is_given, option] : others)
    if (is_given)
      return output::bad_argument(mode, "cannot be combined with " + std::string(option),
                                  "leave out one of them");
  return {};
}

/// The methods of --methods, or those that are measured without it, from the kinds of --moving or
/// --anytime.
template <typename Choice>
auto parse_kinds(const Arguments& arguments, const Choice& choice) {
  using Kind = std::remove_cv_t<typename decltype(choice.known)::element_type>;
  std::vector<std::string_view> names;
  for (const Kind& kind : choice.known) names.push_back(kind.name);
  return parse_list<Kind>("--methods",
                          arguments.methods.empty() ? choice.measured : arguments.methods,
                          choice.known, names);
}

Result<bench::MovingSettings> choose_moving(const Arguments& arguments) {
  const auto kinds = parse_kinds(arguments, arguments.known.moving);
  if (!kinds) return kinds.error();
  bench::MovingSettings settings;
  for (const methods::MovingMethodKind& kind : *kinds)
    settings.methods.push_back(bench::moving_method_of(kind));
  if (const auto set = set_common(arguments, settings); !set) return set.error();
  return settings;
}

Result<bench::AnytimeSettings> choose_anytime(const Arguments& arguments) {
  const auto kinds = parse_kinds(arguments, arguments.known.anytime);
  if (!kinds) return kinds.error();
  if (std::find(kinds->begin(), kinds->end(), methods::kAnytimeContacts) == kinds->end())
    return output::bad_argument("--methods", "the method contacts is missing",
                                "add it, because times are relative to its complete search");
  bench::AnytimeSettings settings;
  for (const methods::AnytimeMethodKind& kind : *kinds)
    settings.methods.push_back(bench::anytime_method_of(kind));
  if (const auto set = set_common(arguments, settings); !set) return set.error();
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

/// Reads the file of --against with `read(path)`. Nullopt without --against.
template <typename Baseline>
Result<std::optional<Baseline>> choose_baseline(const Arguments& arguments,
                                                Result<Baseline> (*read)(const std::string& path)) {
  if (arguments.against.empty() && arguments.margin)
    return output::bad_argument("--margin", "requires --against",
                                "name the file with --against FILE");
  if (arguments.against.empty()) return std::optional<Baseline>();
  auto baseline = read(arguments.against);
  if (!baseline) return baseline.error();
  return std::optional<Baseline>(std::move(*baseline));
}

std::uint32_t margin_of(const Arguments& arguments) {
  return arguments.margin.value_or(bench::kNoisePercent);
}

arguments::ExitCode exit_of(const bench::BenchComparison& comparison, const Arguments& arguments) {
  if (comparison.different_answers == 0) return arguments::ExitCode::success;
  std::cerr
      << arguments.program << ": error: " << output::counted(comparison.different_answers, "answer")
      << " different from " << asset::printable(arguments.against)
      << ": if scenes, characters and options are the same, please report this; if the answers "
         "should differ, write a new file with --json\n";
  return arguments::ExitCode::internal;
}

/// Loads the inputs a second time, because the check needs the names of their models before they
/// are measured.
Result<void> check_output(const Arguments& arguments) {
  if (arguments.json.empty() && arguments.svg.empty() && !output::is_standard_output_a_file())
    return {};
  std::vector<output::InputFile> inputs;
  if (!arguments.against.empty())
    inputs.push_back({arguments.against, "what --against compares with"});
  for (std::size_t i = 0; i < arguments.inputs.size(); ++i) {
    const auto scene = load_input(arguments, i);
    if (!scene) return scene.error();
    for (output::InputFile& file : arguments::files_of_scene(input_alone(arguments, i), *scene))
      inputs.push_back(std::move(file));
  }
  const output::NamedOutput outputs[] = {{"--json", arguments.json}, {"--svg", arguments.svg}};
  return output::check_outputs(outputs, inputs);
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

/// The files that a run writes. Those that are not named are not written.
struct Outputs {
  output::OutputFile json, svg;
};

Result<void> open_outputs(const Arguments& arguments, Outputs& outputs) {
  if (const auto checked = check_output(arguments); !checked) return checked;
  if (const auto opened = outputs.json.open(arguments.json); !opened) return opened;
  return outputs.svg.open(arguments.svg);
}

/// Does nothing without a name.
Result<void> write_output(const std::string& name, const std::string& text,
                          output::OutputFile& file, std::ostream& words) {
  if (name.empty()) return {};
  const auto written = file.write_and_close(std::as_bytes(std::span(text)));
  if (written) output::print_written(name, words);
  return written;
}

std::ostream& words_of(const Arguments& arguments) {
  return output::words_beside({arguments.json, arguments.svg});
}

/// Loads each input, and appends its figures with `measure(scene, figures)` and prints them with
/// `print(figures, words)`. Stops if a method gives a wrong answer.
template <typename Figures, typename Measure, typename Print>
Result<arguments::ExitCode> bench_each(const Arguments& arguments, std::vector<Figures>& figures,
                                       const Measure& measure, const Print& print) {
  std::ostream& words = words_of(arguments);
  for (std::size_t i = 0; i < arguments.inputs.size(); ++i) {
    const auto scene = load_input(arguments, i);
    if (!scene) return scene.error();
    for (const std::string& note : scene->notes) words << "note: " << note << '\n';
    const Result<arguments::ExitCode> exit = measure(*scene, figures);
    if (!exit || *exit != arguments::ExitCode::success) return exit;
    if (figures.size() == 1) bench::print_machine(words);
    print(figures.back(), words);
  }
  return arguments::ExitCode::success;
}

Result<arguments::ExitCode> bench_steps(const Arguments& arguments) {
  if (const auto checked = check_alone("--moving", arguments); !checked) return checked.error();
  const Result<bench::MovingSettings> settings = choose_moving(arguments);
  if (!settings) return settings.error();
  const auto baseline = choose_baseline(arguments, bench::read_moving_baseline);
  if (!baseline) return baseline.error();
  Outputs outputs;
  if (const auto opened = open_outputs(arguments, outputs); !opened) return opened.error();
  std::vector<bench::MovingSceneFigures> figures;
  const auto exit = bench_each(
      arguments, figures,
      [&](const auto& scene, auto& all) {
        return bench::bench_moving(scene, *settings, all, std::cerr);
      },
      bench::print_moving_figures);
  if (!exit || *exit != arguments::ExitCode::success) return exit;
  std::ostream& words = words_of(arguments);
  const auto written =
      write_output(arguments.json, bench::moving_figures_json(figures), outputs.json, words);
  if (!written) return written.error();
  if (!*baseline) return exit;
  return exit_of(bench::print_moving_comparison(**baseline, figures, margin_of(arguments), words),
                 arguments);
}

Result<arguments::ExitCode> bench_searches(const Arguments& arguments) {
  if (const auto checked = check_alone("--anytime", arguments); !checked) return checked.error();
  const Result<bench::AnytimeSettings> settings = choose_anytime(arguments);
  if (!settings) return settings.error();
  Outputs outputs;
  if (const auto opened = open_outputs(arguments, outputs); !opened) return opened.error();
  std::vector<bench::AnytimeSceneFigures> figures;
  const auto exit = bench_each(
      arguments, figures,
      [&](const auto& scene, auto& all) {
        return bench::bench_anytime(scene, *settings, all, std::cerr);
      },
      bench::print_anytime_figures);
  if (!exit || *exit != arguments::ExitCode::success) return exit;
  std::ostream& words = words_of(arguments);
  const auto json =
      write_output(arguments.json, bench::anytime_figures_json(figures), outputs.json, words);
  if (!json) return json.error();
  const auto svg = write_output(arguments.svg, bench::anytime_chart(figures), outputs.svg, words);
  if (!svg) return svg.error();
  return exit;
}

/// Returns an error if a mode that queries pairs of instances got models.
Result<void> require_scenes(const Arguments& arguments, bool only_models) {
  if (!only_models) return {};
  for (const auto& [is_given, mode] :
       {std::pair(arguments.is_moving, "--moving"), std::pair(arguments.is_anytime, "--anytime")})
    if (is_given)
      return output::bad_argument(mode, "requires scene files", "write a scene of the models");
  return {};
}

Result<arguments::ExitCode> bench_inputs(Arguments arguments) {
  const Result<bool> only_models = has_only_models(arguments);
  if (!only_models) return only_models.error();
  arguments.is_self = arguments.is_self || *only_models;
  if (arguments.clips.size() > arguments.inputs.size())
    return output::bad_argument("--clip", "was given more often than there are models",
                                "give it at most once per model, in the order of the models");
  if (const auto chosen = arguments::choose_simd(arguments.simd); !chosen) return chosen.error();
  if (const auto checked = require_scenes(arguments, *only_models); !checked)
    return checked.error();
  if (!arguments.svg.empty() && !arguments.is_anytime)
    return output::bad_argument("--svg", "requires --anytime", "add --anytime");
  if (arguments.is_anytime) return bench_searches(arguments);
  if (arguments.is_moving) return bench_steps(arguments);
  const Result<bench::BenchSettings> settings = choose(arguments);
  if (!settings) return settings.error();
  const auto baseline = choose_baseline(arguments, bench::read_baseline);
  if (!baseline) return baseline.error();
  Outputs outputs;
  if (const auto opened = open_outputs(arguments, outputs); !opened) return opened.error();
  std::vector<bench::SceneFigures> figures;
  const auto exit = bench_each(
      arguments, figures,
      [&](const auto& scene, auto& all) {
        return bench::bench_scene(scene, *settings, all, std::cerr);
      },
      bench::print_figures);
  if (!exit || *exit != arguments::ExitCode::success) return exit;
  std::ostream& words = words_of(arguments);
  const auto written =
      write_output(arguments.json, bench::figures_json(figures), outputs.json, words);
  if (!written) return written.error();
  if (!*baseline) return exit;
  return exit_of(bench::print_comparison(**baseline, figures, margin_of(arguments), words),
                 arguments);
}

/// The names of --moving or --anytime.
template <typename Kind>
std::string listed(std::span<const Kind> kinds) {
  std::string list;
  for (const Kind& kind : kinds) list.append(list.empty() ? "" : ", ").append(kind.name);
  return list;
}

std::string help_on_methods(const BenchMethods& known) {
  return "Methods to measure, separated by commas, of " + methods::listed(known.pairs.known) +
         " (default: " + known.pairs.measured + "); with --self, of " +
         methods::listed(known.self.known) + " (default: " + known.self.measured +
         "); with --moving, of " + listed(known.moving.known) +
         " (default: " + known.moving.measured + "); with --anytime, of " +
         listed(known.anytime.known) + " (default: all)";
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
  verb.flag("--anytime", arguments.is_anytime,
            "Show what is known about pairs in contact when their search is stopped");
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
  verb.option("--svg", arguments.svg, "With --anytime: draw a chart", {.type = "FILE"});
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

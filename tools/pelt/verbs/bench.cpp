/// `pelt bench`: the cost of each method on a scene, in the steps between its frames, or on a
/// character against itself; and what a search knows when it is stopped. Prints no time unless all
/// methods give the same answer.

#include "asset/printable.hpp"
#include "tools/pelt/arguments/scene_arguments.hpp"
#include "tools/pelt/arguments/values.hpp"
#include "tools/pelt/arguments/verb.hpp"
#include "tools/pelt/bench/anytime_chart.hpp"
#include "tools/pelt/bench/anytime_report.hpp"
#include "tools/pelt/bench/bench_against.hpp"
#include "tools/pelt/bench/bench_arguments.hpp"
#include "tools/pelt/bench/moving_against.hpp"
#include "tools/pelt/output/output_conflicts.hpp"
#include "tools/pelt/output/output_file.hpp"
#include "tools/pelt/output/text.hpp"
#include "tools/pelt/verbs/commands.hpp"

#include <algorithm>
#include <filesystem>
#include <iostream>

namespace pelt::tools::verbs {
namespace {

using bench::BenchArguments;

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
mean_update_us, of_collide, ns_per_pair (null for collide, first and touch), steps_in_contact,
contacts, hash and counters, with double_pairs and exact_pairs: pairs of triangles that were not
decided in float, or not in double.
With --anytime, the format is "pelt-bench-anytime"; scenes have triangles, frames_in_contact, pairs,
contacts, hash, repetitions, collide_us and methods, and methods have method, work, longest_step,
mean_us, area_over_work, area_over_time, over_work, over_time and course: what is known after shares of
the work, of the time, and at many times, with share, time, listed, undecided and resolution.
Names that end in _us are microseconds per frame or step. pelt(1) describes each field, with an example.)";

/// The command line of input `i` alone.
arguments::SceneArguments input_alone(const BenchArguments& arguments, std::size_t i) {
  arguments::SceneArguments alone;
  alone.inputs = {arguments.inputs[i]};
  if (i < arguments.clips.size()) alone.clips = {arguments.clips[i]};
  alone.fps = arguments.fps;
  alone.models = arguments.models;
  return alone;
}

/// Loads an input. The name tells inputs with different answers apart.
Result<scenes::Scene> load_input(const BenchArguments& arguments, std::size_t i) {
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
Result<std::optional<Baseline>> choose_baseline(const BenchArguments& arguments,
                                                Result<Baseline> (*read)(const std::string& path)) {
  if (arguments.against.empty() && arguments.margin)
    return output::bad_argument("--margin", "requires --against",
                                "name the file with --against FILE");
  if (arguments.against.empty()) return std::optional<Baseline>();
  auto baseline = read(arguments.against);
  if (!baseline) return baseline.error();
  return std::optional<Baseline>(std::move(*baseline));
}

arguments::ExitCode exit_of(const bench::BenchComparison& comparison,
                            const BenchArguments& arguments) {
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
Result<void> check_output(const BenchArguments& arguments) {
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
Result<bool> has_only_models(const BenchArguments& arguments) {
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

Result<void> open_outputs(const BenchArguments& arguments, Outputs& outputs) {
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

std::ostream& words_of(const BenchArguments& arguments) {
  return output::words_beside({arguments.json, arguments.svg});
}

/// How to measure inputs: in frames, in steps between frames, or as searches that are stopped.
template <typename Settings, typename Figures>
struct Mode {
  Result<arguments::ExitCode> (*measure)(const scenes::Scene& scene, const Settings& settings,
                                         std::vector<Figures>& figures, std::ostream& errors);
  void (*print)(const Figures& figures, std::ostream& words);
  std::string (*json)(const std::vector<Figures>& figures);
};

/// Loads each input, appends its figures and prints them, and writes the file of --json. Stops if a
/// method gives a wrong answer.
template <typename Settings, typename Figures>
Result<arguments::ExitCode> measure_all(const BenchArguments& arguments,
                                        const Mode<Settings, Figures>& mode,
                                        const Settings& settings, output::OutputFile& json,
                                        std::vector<Figures>& figures) {
  std::ostream& words = words_of(arguments);
  for (std::size_t i = 0; i < arguments.inputs.size(); ++i) {
    const auto scene = load_input(arguments, i);
    if (!scene) return scene.error();
    for (const std::string& note : scene->notes) words << "note: " << note << '\n';
    const Result<arguments::ExitCode> exit = mode.measure(*scene, settings, figures, std::cerr);
    if (!exit || *exit != arguments::ExitCode::success) return exit;
    if (figures.size() == 1) bench::print_machine(words);
    mode.print(figures.back(), words);
  }
  const auto written = write_output(arguments.json, mode.json(figures), json, words);
  if (!written) return written.error();
  return arguments::ExitCode::success;
}

/// Measures all inputs, and compares with the file of --against, which `read` reads. `compare`
/// prints the comparison.
template <typename Settings, typename Figures, typename Baseline, typename Compare>
Result<arguments::ExitCode> measure_and_compare(const BenchArguments& arguments,
                                                const Mode<Settings, Figures>& mode,
                                                const Result<Settings>& settings,
                                                Result<Baseline> (*read)(const std::string& path),
                                                const Compare& compare) {
  if (!settings) return settings.error();
  const auto baseline = choose_baseline(arguments, read);
  if (!baseline) return baseline.error();
  Outputs outputs;
  if (const auto opened = open_outputs(arguments, outputs); !opened) return opened.error();
  std::vector<Figures> figures;
  const auto exit = measure_all(arguments, mode, *settings, outputs.json, figures);
  if (!exit || *exit != arguments::ExitCode::success || !*baseline) return exit;
  return exit_of(compare(**baseline, figures, arguments.margin.value_or(bench::kNoisePercent),
                         words_of(arguments)),
                 arguments);
}

Result<arguments::ExitCode> bench_frames(const BenchArguments& arguments) {
  const Mode<bench::BenchSettings, bench::SceneFigures> mode = {
      bench::bench_scene, bench::print_figures, bench::figures_json};
  return measure_and_compare(arguments, mode, bench::choose_scene_settings(arguments),
                             bench::read_baseline, bench::print_comparison);
}

Result<arguments::ExitCode> bench_steps(const BenchArguments& arguments) {
  const Mode<bench::MovingSettings, bench::MovingSceneFigures> mode = {
      bench::bench_moving, bench::print_moving_figures, bench::moving_figures_json};
  return measure_and_compare(arguments, mode, bench::choose_moving_settings(arguments),
                             bench::read_moving_baseline, bench::print_moving_comparison);
}

Result<arguments::ExitCode> bench_searches(const BenchArguments& arguments) {
  const Mode<bench::AnytimeSettings, bench::AnytimeSceneFigures> mode = {
      bench::bench_anytime, bench::print_anytime_figures, bench::anytime_figures_json};
  const auto settings = bench::choose_anytime_settings(arguments);
  if (!settings) return settings.error();
  Outputs outputs;
  if (const auto opened = open_outputs(arguments, outputs); !opened) return opened.error();
  std::vector<bench::AnytimeSceneFigures> figures;
  const auto exit = measure_all(arguments, mode, *settings, outputs.json, figures);
  if (!exit || *exit != arguments::ExitCode::success) return exit;
  const auto svg =
      write_output(arguments.svg, bench::anytime_chart(figures), outputs.svg, words_of(arguments));
  if (!svg) return svg.error();
  return exit;
}

/// Returns an error if a mode that queries pairs of instances got models.
Result<void> require_scenes(const BenchArguments& arguments, bool only_models) {
  if (!only_models) return {};
  for (const auto& [is_given, mode] :
       {std::pair(arguments.is_moving, "--moving"), std::pair(arguments.is_anytime, "--anytime")})
    if (is_given)
      return output::bad_argument(mode, "requires scene files", "write a scene of the models");
  return {};
}

Result<arguments::ExitCode> bench_inputs(BenchArguments arguments) {
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
  return bench_frames(arguments);
}

}  // namespace

void add_bench(CLI::App& app, arguments::Command& chosen, const bench::BenchMethods& methods) {
  arguments::Verb verb(app, "bench", "Measure the speed of methods on scenes and characters",
                       (kFooter + methods.notes).c_str());
  const auto arguments = std::make_shared<BenchArguments>();
  arguments->program = verb.program();
  arguments->known = methods;
  bench::add_bench_options(verb, *arguments);
  verb.runs([arguments] { return bench_inputs(*arguments); }, chosen);
}

}  // namespace pelt::tools::verbs

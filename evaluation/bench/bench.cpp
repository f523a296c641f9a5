/// `pelt-lab bench` adds to `pelt bench` more methods, cold caches, the steps between frames
/// (--moving), searches that are stopped (--anytime), and the comparison with an earlier run
/// (--against).

#include "evaluation/bench/bench.hpp"

#include "base/workers.hpp"
#include "evaluation/bench/against.hpp"
#include "evaluation/bench/anytime_bench.hpp"
#include "evaluation/bench/anytime_figures.hpp"
#include "evaluation/bench/moving_bench.hpp"
#include "text/format.hpp"
#include "text/message.hpp"
#include "text/printable.hpp"
#include "tools/pelt/arguments/verb.hpp"
#include "tools/pelt/bench/bench_run.hpp"
#include "tools/pelt/output/output_file.hpp"

#include <algorithm>
#include <atomic>
#include <iostream>
#include <sstream>

namespace pelt::lab {
namespace {

namespace arguments = tools::arguments;
namespace bench = tools::bench;
namespace output = tools::output;

using arguments::ExitCode;
using bench::Row;

constexpr const char* kFooter = R"(
Examples:
  pelt-lab bench scene.json --caches hot,cold --json figures.json
  pelt-lab bench scene.json --against figures.json
  pelt-lab bench knight.glb --clip Walk
  pelt-lab bench scene.json --moving
  pelt-lab bench scene.json --anytime --frames 20:40:5 --svg anytime.svg

Measures as `pelt bench`, and in these ways, which evaluation/README.md describes:
--caches cold reads 64 MB before each measurement, and measures at most 30 evenly spaced frames.
--moving measures the queries between frames, --anytime what a search knows when it is stopped.
--against compares the ratios to other methods with those in a file of --json. An answer that differs
from the file is a failure, with exit code 3; a slower method is not.

rigid and paper_rigid show the cost of the same query between rigid bodies: building their trees is
not timed. The column "of rigid" is the cost over that of rigid.)";

constexpr const char *kContacts = "contacts,resolution,first_contact,paper",
                     *kMoving = "eager,united,on_demand", *kHotAndCold = "hot,cold";

constexpr bench::Yardstick kYardsticks[] = {bench::kYardsticks[0],
                                            bench::kYardsticks[1],
                                            {"of_rigid", "of rigid", "rigid", true},
                                            bench::kYardsticks[2]};

struct LabArguments : bench::BenchArguments {
  bool is_moving = false, is_anytime = false;
  std::string caches = kHotAndCold, svg, against;
  std::optional<std::uint32_t> margin;
};

template <typename Kinds>
std::vector<std::string_view> names_of(const Kinds& kinds) {
  std::vector<std::string_view> names;
  for (const auto& kind : kinds) names.push_back(kind.name);
  return names;
}

std::string joined(const std::vector<std::string_view>& names) {
  std::string list;
  for (const std::string_view name : names) list.append(list.empty() ? "" : ", ").append(name);
  return list;
}

void add_options(arguments::Verb& verb, LabArguments& lab) {
  bench::add_bench_options(verb, lab,
                           "; with --moving, of " + joined(names_of(kMovingMethods)) +
                               " (default: " + kMoving + "); with --anytime, of " +
                               joined(names_of(kAnytimeMethods)) + " (default: all)");
  verb.flag("--moving", lab.is_moving, "Query the steps between the frames of scenes");
  verb.flag("--anytime", lab.is_anytime,
            "Show what is known about pairs in contact when their search is stopped");
  verb.option("--caches", lab.caches, "hot: as the previous frame left them; cold: emptied",
              {.type = "hot,cold"});
  verb.option("--svg", lab.svg, "With --anytime: draw a chart", {.type = "FILE"});
  verb.option("--against", lab.against, "Compare with figures that --json has written",
              {.type = "FILE"});
  verb.option("--margin", lab.margin,
              "Mark ratios that have become worse by more than PERCENT per cent (default: " +
                  std::to_string(kNoisePercent) + ")",
              {.type = "PERCENT", .most = 1000});
}

/// Returns an error if an option was given that cannot be combined with `mode`, which is --moving
/// or --anytime.
Result<void> check_alone(const char* mode, const LabArguments& lab) {
  const std::pair<bool, const char*> others[] = {
      {lab.is_self, "--self"},
      {lab.is_moving && lab.is_anytime, "--moving"},
      {lab.queries != bench::kAllQueries, "--queries"},
      {lab.caches != kHotAndCold, "--caches"},
      {!lab.threads.empty(), "--threads"},
      {lab.is_anytime && !lab.against.empty(), "--against"},
      {lab.is_anytime && lab.margin.has_value(), "--margin"}};
  for (const auto& [is_given, option] : others)
    if (is_given)
      return text::bad_argument(mode, "cannot be combined with " + std::string(option),
                                "leave out one of them");
  return {};
}

Result<void> check_options(const LabArguments& lab, bool only_models) {
  for (const auto& [is_given, mode] :
       {std::pair(lab.is_moving, "--moving"), std::pair(lab.is_anytime, "--anytime")})
    if (is_given && only_models)
      return text::bad_argument(mode, "requires scene files", "write a scene of the models");
  if (!lab.svg.empty() && !lab.is_anytime)
    return text::bad_argument("--svg", "requires --anytime", "add --anytime");
  if (lab.is_anytime || lab.is_moving) {
    const char* mode = lab.is_anytime ? "--anytime" : "--moving";
    if (const auto checked = check_alone(mode, lab); !checked) return checked;
  }
  if (lab.against.empty() && lab.margin)
    return text::bad_argument("--margin", "requires --against",
                              "name the file with --against FILE");
  return {};
}

/// Reads more memory than the caches hold, on as many threads as the method has, because each core
/// has caches of its own. Stores the sum, so that the compiler does not remove the reads.
class CacheFlush {
 public:
  void run(std::uint32_t threads) {
    threads_.run(threads, [this](std::uint32_t) {
      std::uint64_t sum = 0;
      for (std::size_t i = 0; i < memory_.size(); i += kWordsPerCacheLine) sum += memory_[i];
      sum_ += sum;
    });
  }

 private:
  static constexpr std::size_t kWordsPerCacheLine = 8;

  std::vector<std::uint64_t> memory_ = std::vector<std::uint64_t>((64u << 20) / 8, 1);
  std::atomic<std::uint64_t> sum_ = 0;
  detail::Workers threads_;
};

Result<bench::BenchSettings> choose_frame_settings(const LabArguments& lab) {
  constexpr std::array<std::string_view, 2> kNames = {"hot", "cold"};
  auto settings = bench::choose_settings(lab);
  if (!settings) return settings;
  const auto caches = bench::parse_names("--caches", lab.caches, kNames);
  if (!caches) return caches.error();
  settings->caches.clear();
  for (const std::size_t i : *caches)
    settings->caches.push_back(i == 0 ? bench::Cache() : cold_cache());
  return settings;
}

/// The settings of --moving or --anytime, with methods of `kinds`.
template <typename Settings, typename Kinds>
Result<Settings> choose_settings(const LabArguments& lab, const Kinds& kinds,
                                 const char* measured) {
  const auto chosen = bench::parse_names("--methods", lab.methods.empty() ? measured : lab.methods,
                                         names_of(kinds));
  if (!chosen) return chosen.error();
  const auto frames = bench::parse_frames(lab);
  if (!frames) return frames.error();
  Settings settings;
  settings.program = lab.program;
  for (const std::size_t i : *chosen) settings.methods.push_back(method_of(kinds[i]));
  settings.repetitions = lab.repetitions;
  settings.frames = *frames;
  settings.models = lab.models;
  return settings;
}

/// The report of a scene from its figures: text by `print`, and JSON.
template <typename Figures, typename Print>
Result<std::optional<bench::SceneReport>> report_of(const Result<std::optional<Figures>>& figures,
                                                    const Print& print) {
  if (!figures) return figures.error();
  if (!*figures) return std::optional<bench::SceneReport>();
  std::ostringstream text;
  print(**figures, text);
  return std::optional(bench::SceneReport{scene_json(**figures), text.str()});
}

ExitCode exit_of(const Comparison& comparison, const LabArguments& lab) {
  if (comparison.different_answers == 0) return ExitCode::success;
  std::cerr
      << lab.program << ": error: " << text::counted(comparison.different_answers, "answer")
      << " different from " << text::printable(lab.against)
      << ": if scenes, characters and options are the same, please report this; if the answers "
         "should differ, write a new file with --json\n";
  return ExitCode::internal;
}

/// Measures all inputs, compares them with the file of --against, and writes all outputs.
/// `chart(...)` is called after the inputs are measured; "" for no chart.
Result<ExitCode> run(const LabArguments& lab, const char* format, const ComparedFigures* compared,
                     const bench::MeasureScene& measure,
                     const std::function<std::string()>& chart = {}) {
  std::optional<Baseline> baseline;
  std::vector<output::InputFile> read;
  if (!lab.against.empty()) {
    auto then = read_baseline(lab.against, compared->format);
    if (!then) return then.error();
    baseline = std::move(*then);
    read.push_back({lab.against, "what --against compares with"});
  }
  const output::NamedOutput outputs[] = {{"--json", lab.json}, {"--svg", lab.svg}};
  if (const auto checked = bench::check_outputs(lab, outputs, std::move(read)); !checked)
    return checked.error();
  output::OutputFile json, svg;
  if (const auto opened = json.open(lab.json); !opened) return opened.error();
  if (const auto opened = svg.open(lab.svg); !opened) return opened.error();
  std::ostream& words = output::words_beside({lab.json, lab.svg});
  std::vector<Row> scenes;
  const auto exit = bench::measure_inputs(lab, format, measure, json, scenes, words);
  if (!exit || *exit != ExitCode::success) return exit;
  if (chart)
    if (const auto drawn = bench::write_output(lab.svg, chart(), svg, words); !drawn)
      return drawn.error();
  if (!baseline) return exit;
  return exit_of(
      print_comparison(*compared, *baseline, scenes, lab.margin.value_or(kNoisePercent), words),
      lab);
}

Result<ExitCode> bench_frames(const LabArguments& lab) {
  const auto settings = choose_frame_settings(lab);
  if (!settings) return settings.error();
  return run(lab, kFramesFormat.name, &kComparedFrames,
             [&](const scenes::Scene& scene, std::ostream& errors) {
               return report_of(bench::bench_scene(scene, *settings, errors),
                                [](const bench::SceneFigures& figures, std::ostream& out) {
                                  bench::print_figures(figures, kYardsticks, out);
                                });
             });
}

Result<ExitCode> bench_steps(const LabArguments& lab) {
  const auto settings = choose_settings<MovingSettings>(lab, kMovingMethods, kMoving);
  if (!settings) return settings.error();
  return run(lab, kStepsFormat.name, &kComparedSteps,
             [&](const scenes::Scene& scene, std::ostream& errors) {
               return report_of(bench_moving(scene, *settings, errors),
                                [](const MovingSceneFigures& figures, std::ostream& out) {
                                  print_figures(figures, out);
                                });
             });
}

Result<ExitCode> bench_searches(const LabArguments& lab) {
  const auto settings = choose_settings<AnytimeSettings>(lab, kAnytimeMethods, kContacts);
  if (!settings) return settings.error();
  const auto& methods = settings->methods;
  if (std::none_of(methods.begin(), methods.end(),
                   [](const auto& method) { return method.name == kAnytimeContacts.name; }))
    return text::bad_argument("--methods", "the method contacts is missing",
                              "add it, because times are relative to its complete search");
  std::vector<AnytimeSceneFigures> all;
  return run(
      lab, "pelt-bench-anytime", nullptr,
      [&](const scenes::Scene& scene, std::ostream& errors) {
        const auto figures = bench_anytime(scene, *settings, errors);
        if (figures && *figures) all.push_back(**figures);
        return report_of(figures, [](const AnytimeSceneFigures& of, std::ostream& out) {
          print_figures(of, out);
        });
      },
      [&] { return anytime_chart(all); });
}

Result<ExitCode> run_bench(LabArguments lab) {
  const bool is_self = lab.is_self;
  if (const auto prepared = bench::prepare_inputs(lab); !prepared) return prepared.error();
  const bool only_models = lab.is_self && !is_self;
  if (const auto checked = check_options(lab, only_models); !checked) return checked.error();
  if (lab.is_anytime) return bench_searches(lab);
  if (lab.is_moving) return bench_steps(lab);
  return bench_frames(lab);
}

}  // namespace

const ComparedFigures kComparedFrames = {kFramesFormat,
                                         "frame",
                                         {"query", "cache", "method", "threads"},
                                         kYardsticks,
                                         {"paper", "rigid", "boxes"}};

const ComparedFigures kComparedSteps = {
    kStepsFormat, "step", {"query", "method"}, kMovingYardsticks};

bench::Cache cold_cache() {
  constexpr std::size_t kMostFrames = 30;
  const auto flush = std::make_shared<CacheFlush>();
  return {"cold", [flush](std::uint32_t threads) { flush->run(threads); }, kMostFrames};
}

bench::BenchMethod rival_method(const std::string& name, const MakeRival& make) {
  return {name, [make](std::span<const tools::scene::Collider> colliders) {
            return tools::scene::SceneQuery(colliders, adapt(make()));
          }};
}

bench::BenchMethod self_rival_method(const std::string& name, const MakeRival& make) {
  return {name,
          [make](std::span<const tools::scene::Collider> colliders) {
            return tools::scene::SceneQuery::of_each(colliders, adapt(make()));
          },
          bench::Asked::self};
}

void add_bench(CLI::App& app, arguments::Command& chosen) {
  arguments::Verb verb(app, "bench", "Measure the speed of methods on scenes and characters",
                       kFooter);
  const auto lab = std::make_shared<LabArguments>();
  lab->program = verb.program();
  lab->known = {{kLabMethods, "paper,paper_eager,eager,on_demand,rigid"},
                {kLabSelfMethods, "boxes,self,eager"}};
  add_options(verb, *lab);
  verb.runs([lab] { return run_bench(*lab); }, chosen);
}

}  // namespace pelt::lab

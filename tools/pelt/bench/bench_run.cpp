#include "tools/pelt/bench/bench_run.hpp"

#include "text/format.hpp"
#include "text/message.hpp"
#include "text/printable.hpp"
#include "tools/pelt/arguments/scene_arguments.hpp"
#include "tools/pelt/arguments/values.hpp"
#include "tools/pelt/arguments/verb.hpp"
#include "tools/pelt/bench/machine.hpp"
#include "tools/pelt/methods/command_methods.hpp"
#include "tools/pelt/output/output_file.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <iostream>

namespace pelt::tools::bench {
namespace {

/// A larger number is probably a typing error.
constexpr std::uint32_t kMaxThreads = 256;

Result<std::vector<methods::MethodKind>> parse_methods(const BenchArguments& arguments) {
  const auto& [known, measured] = arguments.is_self ? arguments.known.self : arguments.known.pairs;
  const std::string& names = arguments.methods.empty() ? measured : arguments.methods;
  const auto chosen = parse_names("--methods", names, methods::names_of(known));
  if (!chosen) return chosen.error();
  std::vector<methods::MethodKind> kinds;
  for (const std::size_t i : *chosen) kinds.push_back(known[i]);
  return kinds;
}

/// Parses numbers of threads; none if the text is empty.
Result<std::vector<std::uint32_t>> parse_threads(const std::string& text) {
  std::vector<std::uint32_t> counts;
  if (text.empty()) return counts;
  for (const std::string_view word : text::split(text, ',')) {
    std::uint32_t count = 0;
    if (!text::parse_whole(word, count) || count == 0 || count > kMaxThreads) {
      return text::bad_argument(
          "--threads", text::quoted(word) + " is not a number of threads",
          "give numbers from 1 to " + std::to_string(kMaxThreads) + " with commas between them");
    }
    if (std::find(counts.begin(), counts.end(), count) == counts.end()) counts.push_back(count);
  }
  return counts;
}

Result<std::vector<BenchMethod>> choose_methods(const BenchArguments& arguments) {
  const auto kinds = parse_methods(arguments);
  if (!kinds) return kinds.error();
  const auto threads = parse_threads(arguments.threads);
  if (!threads) return threads.error();
  std::vector<BenchMethod> methods;
  for (const methods::MethodKind& method : *kinds) {
    if (arguments.is_self)
      methods.push_back(self_method(method));
    else if (method != methods::kOnDemand || threads->empty())
      methods.push_back(method_of(method));
    else
      for (const std::uint32_t count : *threads) methods.push_back(crowd_method(count));
  }
  if (!threads->empty() && time_of(methods) == Time::thread) {
    return text::bad_argument(
        "--threads", "only the method on_demand for pairs of instances supports several threads",
        "add on_demand to --methods, or leave out --threads");
  }
  return methods;
}

bool is_scene_file(const std::string& path) {
  return std::filesystem::path(path).extension() == ".json";
}

/// The command line of input `i` alone.
arguments::SceneArguments input_alone(const BenchArguments& arguments, std::size_t i) {
  arguments::SceneArguments alone;
  alone.inputs = {arguments.inputs[i]};
  if (i < arguments.clips.size()) alone.clips = {arguments.clips[i]};
  alone.fps = arguments.fps;
  alone.models = arguments.models;
  return alone;
}

}  // namespace

void add_bench_options(arguments::Verb& verb, BenchArguments& arguments,
                       const std::string& more_methods) {
  const auto& [pairs, self] = arguments.known;
  verb.option("INPUT", arguments.inputs, "Scene files, or models to query against themselves",
              {.is_required = true});
  verb.option("--clip", arguments.clips,
              "Animation clip of a model, repeatable, in the order of the models; '*': all clips",
              {.type = "NAME"});
  verb.option("--fps", arguments.fps,
              "Frames per second of clips (default: that of the scene, or 30)", {.type = "FPS"});
  verb.flag("--self", arguments.is_self, "Query each instance of a scene against itself");
  verb.option("--methods", arguments.methods,
              "Methods to measure, separated by commas, of " + methods::listed(pairs.known) +
                  " (default: " + pairs.measured + "); with --self, of " +
                  methods::listed(self.known) + " (default: " + self.measured + ")" + more_methods,
              {.type = "A,B"});
  verb.option("--queries", arguments.queries,
              "all: every contact; first: only whether each pair touches", {.type = "all,first"});
  verb.option("--threads", arguments.threads,
              "Run on_demand as a crowd on N threads, on M threads, ...", {.type = "N,M"});
  verb.option("--repeat", arguments.repetitions, "Repetitions of each frame",
              {.type = "N", .least = 1});
  verb.option("--frames", arguments.frames, "Frames A to B - 1, each S-th of them",
              {.type = "A:B[:S]"});
  verb.option("--json", arguments.json, "Write the figures", {.type = "FILE"});
  arguments::add_simd_option(verb, arguments.simd);
  arguments::add_model_options(verb, arguments.models);
}

Result<std::vector<std::size_t>> parse_names(const char* option, const std::string& text,
                                             std::span<const std::string_view> names) {
  std::vector<std::size_t> chosen;
  for (const std::string_view name : text::split(text, ',')) {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end())
      return Error{ErrorCode::invalid_argument, std::string(option) + ": unknown value " +
                                                    text::quoted(name) +
                                                    text::suggestion(name, names)};
    const auto at = static_cast<std::size_t>(found - names.begin());
    if (std::find(chosen.begin(), chosen.end(), at) == chosen.end()) chosen.push_back(at);
  }
  return chosen;
}

Result<std::optional<arguments::FrameRange>> parse_frames(const BenchArguments& arguments) {
  if (arguments.frames.empty()) return std::optional<arguments::FrameRange>();
  const auto frames = arguments::parse_frame_range(arguments.frames);
  if (!frames) return frames.error();
  return std::optional(*frames);
}

Result<BenchSettings> choose_settings(const BenchArguments& arguments) {
  constexpr std::array<std::string_view, 2> kQuestions = {"all", "first"};
  const auto methods = choose_methods(arguments);
  if (!methods) return methods.error();
  const auto questions = parse_names("--queries", arguments.queries, kQuestions);
  if (!questions) return questions.error();
  const auto frames = parse_frames(arguments);
  if (!frames) return frames.error();
  BenchSettings settings;
  settings.program = arguments.program;
  settings.methods = *methods;
  settings.is_self = arguments.is_self;
  for (const std::size_t i : *questions) settings.questions.push_back(static_cast<Question>(i));
  settings.repetitions = arguments.repetitions;
  settings.frames = *frames;
  settings.models = arguments.models;
  return settings;
}

Result<void> prepare_inputs(BenchArguments& arguments) {
  const auto& inputs = arguments.inputs;
  const auto scenes = std::count_if(inputs.begin(), inputs.end(), is_scene_file);
  if (scenes > 0 && !arguments.clips.empty())
    return text::bad_argument("--clip", "applies to models, not to a scene file",
                              "edit the scene file instead");
  // Scenes and models have different methods and tables.
  if (scenes > 0 && scenes < std::ssize(inputs) && !arguments.is_self)
    return text::bad_argument("INPUT", "scenes and models cannot be measured in one run",
                              "add --self, or start a run for each");
  arguments.is_self = arguments.is_self || scenes == 0;
  if (arguments.clips.size() > inputs.size())
    return text::bad_argument("--clip", "was given more often than there are models",
                              "give it at most once per model, in the order of the models");
  return arguments::choose_simd(arguments.simd);
}

Result<scenes::Scene> load_input(const BenchArguments& arguments, std::size_t i) {
  const arguments::SceneArguments alone = input_alone(arguments, i);
  Result<scenes::Scene> scene = arguments::open_scene(alone);
  if (!scene || !arguments.is_self) return scene;
  scene->name = std::filesystem::path(alone.inputs[0]).filename().string();
  for (const std::string& clip : alone.clips) scene->name += " " + clip;
  if (arguments::asks_for_scene(alone)) scene->name += " --self";
  return scene;
}

Result<void> check_outputs(const BenchArguments& arguments,
                           std::span<const output::NamedOutput> outputs,
                           std::vector<output::InputFile> inputs) {
  const bool writes = std::any_of(outputs.begin(), outputs.end(),
                                  [](const auto& named) { return !named.name.empty(); });
  if (!writes && !output::is_standard_output_a_file()) return {};
  for (std::size_t i = 0; i < arguments.inputs.size(); ++i) {
    const auto scene = load_input(arguments, i);
    if (!scene) return scene.error();
    for (output::InputFile& file : arguments::files_of_scene(input_alone(arguments, i), *scene))
      inputs.push_back(std::move(file));
  }
  return output::check_outputs(outputs, inputs);
}

Result<arguments::ExitCode> measure_inputs(const BenchArguments& arguments, const char* format,
                                           const MeasureScene& measure, output::OutputFile& json,
                                           std::vector<Row>& scenes, std::ostream& words) {
  for (std::size_t i = 0; i < arguments.inputs.size(); ++i) {
    const auto scene = load_input(arguments, i);
    if (!scene) return scene.error();
    for (const std::string& note : scene->notes) words << "note: " << note << '\n';
    auto report = measure(*scene, std::cerr);
    if (!report) return report.error();
    if (!*report) return arguments::ExitCode::internal;
    if (scenes.empty()) words << in_words(this_machine()) << "\n\n";
    words << (*report)->text << std::flush;
    scenes.push_back(std::move((*report)->json));
  }
  const auto written = write_output(arguments.json, figures_json(format, scenes), json, words);
  if (!written) return written.error();
  return arguments::ExitCode::success;
}

Result<void> write_output(const std::string& name, const std::string& text,
                          output::OutputFile& file, std::ostream& words) {
  if (name.empty()) return {};
  const auto written = file.write_and_close(std::as_bytes(std::span(text)));
  if (written) output::print_written(name, words);
  return written;
}

}  // namespace pelt::tools::bench

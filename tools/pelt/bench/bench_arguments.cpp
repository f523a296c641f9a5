#include "tools/pelt/bench/bench_arguments.hpp"

#include "asset/message.hpp"
#include "scenes/closest_name.hpp"
#include "tools/pelt/arguments/values.hpp"
#include "tools/pelt/arguments/verb.hpp"
#include "tools/pelt/bench/bench_against.hpp"
#include "tools/pelt/methods/anytime_methods.hpp"
#include "tools/pelt/methods/command_methods.hpp"
#include "tools/pelt/output/output_file.hpp"
#include "tools/pelt/output/text.hpp"

#include <algorithm>
#include <array>

namespace pelt::tools::bench {
namespace {

/// A larger number is probably a typing error.
constexpr std::uint32_t kMaxThreads = 256;

constexpr std::array kQuestions = {Question::all, Question::first};
constexpr std::array kCaches = {Cache::hot, Cache::cold};

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

Result<std::vector<methods::MethodKind>> parse_methods(const BenchArguments& arguments) {
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
    return output::bad_argument(
        "--threads", "only the method on_demand for pairs of instances supports several threads",
        "add on_demand to --methods, or leave out --threads");
  }
  return methods;
}

/// Nullopt without --frames.
Result<std::optional<arguments::FrameRange>> parse_frames(const BenchArguments& arguments) {
  if (arguments.frames.empty()) return std::optional<arguments::FrameRange>();
  const auto frames = arguments::parse_frame_range(arguments.frames);
  if (!frames) return frames.error();
  return std::optional(*frames);
}

/// Sets what all modes have in common.
template <typename Settings>
Result<void> set_common(const BenchArguments& arguments, Settings& settings) {
  settings.program = arguments.program;
  settings.repetitions = arguments.repetitions;
  settings.models = arguments.models;
  const auto frames = parse_frames(arguments);
  if (!frames) return frames.error();
  settings.frames = *frames;
  return {};
}

/// Returns an error if an option was given that cannot be combined with `mode`, which is --moving
/// or --anytime.
Result<void> check_alone(const char* mode, const BenchArguments& arguments) {
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
auto parse_kinds(const BenchArguments& arguments, const Choice& choice) {
  using Kind = std::remove_cv_t<typename decltype(choice.known)::element_type>;
  std::vector<std::string_view> names;
  for (const Kind& kind : choice.known) names.push_back(kind.name);
  return parse_list<Kind>("--methods",
                          arguments.methods.empty() ? choice.measured : arguments.methods,
                          choice.known, names);
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

}  // namespace

void add_bench_options(arguments::Verb& verb, BenchArguments& arguments) {
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
                  std::to_string(kNoisePercent) + ")",
              {.type = "PERCENT", .most = 1000});
  arguments::add_simd_option(verb, arguments.simd);
  arguments::add_model_options(verb, arguments.models);
}

Result<BenchSettings> choose_scene_settings(const BenchArguments& arguments) {
  BenchSettings settings;
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

Result<MovingSettings> choose_moving_settings(const BenchArguments& arguments) {
  if (const auto checked = check_alone("--moving", arguments); !checked) return checked.error();
  const auto kinds = parse_kinds(arguments, arguments.known.moving);
  if (!kinds) return kinds.error();
  MovingSettings settings;
  for (const methods::MovingMethodKind& kind : *kinds)
    settings.methods.push_back(moving_method_of(kind));
  if (const auto set = set_common(arguments, settings); !set) return set.error();
  return settings;
}

Result<AnytimeSettings> choose_anytime_settings(const BenchArguments& arguments) {
  if (const auto checked = check_alone("--anytime", arguments); !checked) return checked.error();
  const auto kinds = parse_kinds(arguments, arguments.known.anytime);
  if (!kinds) return kinds.error();
  if (std::find(kinds->begin(), kinds->end(), methods::kAnytimeContacts) == kinds->end())
    return output::bad_argument("--methods", "the method contacts is missing",
                                "add it, because times are relative to its complete search");
  AnytimeSettings settings;
  for (const methods::AnytimeMethodKind& kind : *kinds)
    settings.methods.push_back(anytime_method_of(kind));
  if (const auto set = set_common(arguments, settings); !set) return set.error();
  return settings;
}

}  // namespace pelt::tools::bench

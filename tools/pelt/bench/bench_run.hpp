#pragma once

/// A run of `pelt bench`: its options and inputs, and a loop that measures one input after the
/// other.

#include "tools/pelt/arguments/verb.hpp"
#include "tools/pelt/bench/bench_scene.hpp"
#include "tools/pelt/output/output_conflicts.hpp"
#include "tools/pelt/output/output_file.hpp"

namespace pelt::tools::arguments {
class Verb;
}

namespace pelt::tools::bench {

/// Possible values of --methods, and its default, separated by commas.
struct MethodChoice {
  methods::MethodKinds known;  ///< must outlive the command
  std::string measured;
};

/// The methods of a program for pairs of instances, and for an instance against itself.
struct BenchMethods {
  MethodChoice pairs, self;
};

inline constexpr const char* kAllQueries = "all,first";

struct BenchArguments {
  std::string program;
  BenchMethods known;
  std::vector<std::string> inputs, clips;
  bool is_self = false;
  std::optional<double> fps;
  std::string methods, queries = kAllQueries, threads, json, frames, simd;
  std::uint32_t repetitions = kEnoughRepetitions;
  arguments::ModelArguments models;
};

/// Adds the options. `more_methods` ends the help on --methods.
void add_bench_options(arguments::Verb& verb, BenchArguments& arguments,
                       const std::string& more_methods = "");

/// The positions of the names in the list `text` like "all,first"; an error for another name.
Result<std::vector<std::size_t>> parse_names(const char* option, const std::string& text,
                                             std::span<const std::string_view> names);

/// The frames of --frames; nullopt without it.
Result<std::optional<arguments::FrameRange>> parse_frames(const BenchArguments& arguments);

/// The settings of a run, or an error for a value, or for options that cannot be combined.
Result<BenchSettings> choose_settings(const BenchArguments& arguments);

/// Chooses the instruction set, and sets `is_self` if all inputs are models. Returns an error if
/// models and scenes, or clips, cannot be measured in one run.
Result<void> prepare_inputs(BenchArguments& arguments);

/// Loads an input. The name tells inputs with different answers apart.
Result<scenes::Scene> load_input(const BenchArguments& arguments, std::size_t i);

/// Returns an error if an output is an input of the run, or one of `inputs`, or another output.
/// Loads all inputs, because the check needs the names of their models before they are measured.
Result<void> check_outputs(const BenchArguments& arguments,
                           std::span<const output::NamedOutput> outputs,
                           std::vector<output::InputFile> inputs = {});

/// The figures of one scene.
struct SceneReport {
  Row json;
  std::string text;
};

/// Returns nullopt after it has printed to `errors` that answers differ.
using MeasureScene = std::function<Result<std::optional<SceneReport>>(const scenes::Scene& scene,
                                                                      std::ostream& errors)>;

/// Measures each input, prints its tables to `words`, and writes the file of --json, which is open
/// as `json`. Appends the JSON of each scene to `scenes`. Stops if a method gives a wrong answer.
Result<arguments::ExitCode> measure_inputs(const BenchArguments& arguments, const char* format,
                                           const MeasureScene& measure, output::OutputFile& json,
                                           std::vector<Row>& scenes, std::ostream& words);

/// Writes and closes `file`, which is open as `name`. Does nothing without a name.
Result<void> write_output(const std::string& name, const std::string& text,
                          output::OutputFile& file, std::ostream& words);

}  // namespace pelt::tools::bench

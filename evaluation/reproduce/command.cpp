/// `pelt-lab reproduce`: runs the experiments of the paper again and writes a report.

#include <pelt/version.hpp>

#include "evaluation/reproduce/command.hpp"
#include "evaluation/reproduce/experiment.hpp"
#include "evaluation/reproduce/files.hpp"
#include "evaluation/reproduce/real_models.hpp"
#include "evaluation/reproduce/summary.hpp"
#include "text/format.hpp"
#include "text/message.hpp"
#include "tools/pelt/arguments/scene_arguments.hpp"
#include "tools/pelt/arguments/verb.hpp"
#include "tools/pelt/bench/machine.hpp"
#include "tools/pelt/output/output_conflicts.hpp"
#include "tools/pelt/output/output_file.hpp"

#include <algorithm>
#include <chrono>
#include <ctime>
#include <iostream>

namespace pelt::tools::verbs {
namespace {

using reproduce::Experiment;
using reproduce::Report;
using reproduce::Section;

struct Arguments {
  std::string folder = "pelt-reproduce";
  std::string models, only;
  bool is_quick = false, has_peers = false;
};

constexpr const char* kFooter = R"(
Examples:
  pelt-lab reproduce
  pelt-lab reproduce --quick -o report
  pelt-lab reproduce --models characters --only characters,tightness

Runs the experiments of Kavan & Zara 2005, and the comparison that the paper left open, on generated
characters and, with --models, on the .glb files of a folder. Writes report.html, a self-contained
page; results.json and csv/*.csv with every figure; charts/*.svg (by gnuplot) and pictures/*.png (by
POV-Ray). This takes about 20 minutes on two cores, or about 2 with --quick. Keep the machine idle
meanwhile, because times are measured.)";

Result<std::vector<Experiment>> all_experiments(bool has_peers) {
  const auto most = reproduce::experiments();
  std::vector<Experiment> all(most.begin(), most.end());
  if (!has_peers) return all;
  const Experiment* const peers = reproduce::peers_experiment();
  if (peers == nullptr)
    return text::bad_argument(
        "--peers", "pelt-lab was built without adapters to other libraries",
        "build it with -DPELT_BENCH_PEERS=ON, see evaluation/peers/README.md");
  all.push_back(*peers);
  return all;
}

/// The experiments of `all` whose ids `only` lists; all if `only` is empty.
Result<std::vector<Experiment>> chosen_experiments(const std::vector<Experiment>& all,
                                                   const std::string& only) {
  if (only.empty()) return all;
  std::vector<std::string_view> known;
  for (const Experiment& experiment : all) known.push_back(experiment.id);
  std::vector<Experiment> chosen;
  for (const std::string_view id : text::split(only, ',')) {
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const Experiment& e) { return e.id == id; });
    if (found == all.end())
      return Error{ErrorCode::invalid_argument,
                   "--only: no experiment " + text::quoted(id) + text::suggestion(id, known)};
    chosen.push_back(*found);
  }
  return chosen;
}

std::string today() {
  const std::time_t now = std::time(nullptr);
  std::tm utc{};
  gmtime_r(&now, &utc);
  char text[16];
  std::strftime(text, sizeof text, "%Y-%m-%d", &utc);
  return text;
}

std::vector<std::string> provenance(const Arguments& arguments) {
  const bench::Machine machine = bench::this_machine();
  std::vector<std::string> lines = {
      "Measured on " + today() + ": " + machine.cpu + ", " + std::to_string(machine.cores) +
          " cores, " + text::fixed(machine.memory_gib, 0) + " GiB of memory, " + machine.system +
          ".",
      "pelt " PELT_VERSION ", " + machine.compiler + " " + machine.flags + ", " + machine.build +
          "; Pelt's and the rivals' hot code for " + machine.instruction_set + "."};
  if (arguments.is_quick)
    lines.push_back("A quick run: few frames and repetitions, so figures are rough.");
  return lines;
}

Result<Section> run_experiment(const Experiment& experiment,
                               const reproduce::Conditions& conditions) {
  const auto begin = std::chrono::steady_clock::now();
  Result<Section> section = experiment.run(conditions);
  if (!section) return section.error();
  section->id = experiment.id;
  section->title = experiment.title;
  section->seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return section;
}

/// Returns an error if a file that the report may replace is a model, or a file that a model refers
/// to.
Result<void> check_folder(const Arguments& arguments) {
  if (arguments.models.empty()) return {};
  std::vector<output::InputFile> inputs;
  for (const std::filesystem::path& model : reproduce::model_files(arguments.models))
    for (output::InputFile& file : arguments::files_of_model(model.string()))
      inputs.push_back(std::move(file));
  std::vector<output::NamedOutput> outputs;
  for (const std::filesystem::path& file : reproduce::replaced_files(arguments.folder))
    outputs.push_back({"-o", file.string(), "choose another folder"});
  return output::check_outputs(outputs, inputs);
}

Result<arguments::ExitCode> reproduce_all(const Arguments& arguments) {
  const auto all = all_experiments(arguments.has_peers);
  if (!all) return all.error();
  const auto chosen = chosen_experiments(*all, arguments.only);
  if (!chosen) return chosen.error();
  if (!arguments.models.empty() && !std::filesystem::is_directory(arguments.models))
    return text::bad_argument("--models", arguments.models + " is not a folder",
                              "give a folder with .glb files");
  if (const auto checked = check_folder(arguments); !checked) return checked.error();
  if (const auto made = reproduce::make_folders(arguments.folder); !made) return made.error();
  Report report;
  report.provenance = provenance(arguments);
  for (const Experiment& experiment : *chosen) {
    std::cout << '[' << report.sections.size() + 1 << " of " << chosen->size() << "] "
              << experiment.title << std::endl;  // progress bars are drawn on the lines below
    Result<Section> section = run_experiment(experiment, {arguments.is_quick, arguments.models});
    if (!section) return section.error();
    std::cout << "    " << text::fixed(section->seconds, 1) << " s" << std::endl;
    report.sections.push_back(std::move(*section));
  }
  report.sections.insert(report.sections.begin(), summary(report.sections));
  std::cout << "drawing charts and pictures" << std::endl;
  const auto written = reproduce::write_report(report, arguments.folder, std::cout);
  if (!written) return written.error();
  std::cout << "wrote " << arguments.folder << "/report.html\n";
  return arguments::ExitCode::success;
}

}  // namespace

void add_reproduce(CLI::App& app, arguments::Command& chosen) {
  arguments::Verb verb(app, "reproduce", "Run the experiments of the paper again", kFooter);
  const auto arguments = std::make_shared<Arguments>();
  verb.option("-o,--output", arguments->folder, "Folder for the report", {.type = "DIR"});
  verb.flag("--quick", arguments->is_quick, "Use fewer frames, repetitions and sizes");
  verb.option("--models", arguments->models, "Folder with more characters (.glb)", {.type = "DIR"});
  verb.option("--only", arguments->only, "Only these experiments, separated by commas",
              {.type = "LIST"});
  verb.flag("--peers", arguments->has_peers,
            "Compare with other libraries too, if built with them");
  verb.runs([arguments] { return reproduce_all(*arguments); }, chosen);
}

}  // namespace pelt::tools::verbs

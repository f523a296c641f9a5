/// `pelt-lab reproduce`: runs the experiments of the paper again and writes a report.

#include "evaluation/reproduce/command.hpp"

#include <pelt/version.hpp>

#include "evaluation/reproduce/characters.hpp"
#include "evaluation/reproduce/files.hpp"
#include "evaluation/reproduce/report.hpp"
#include "evaluation/reproduce/scene_figures.hpp"
#include "text/format.hpp"
#include "text/message.hpp"
#include "tools/pelt/arguments/scene_arguments.hpp"
#include "tools/pelt/bench/machine.hpp"
#include "tools/pelt/output/output_conflicts.hpp"
#include "tools/pelt/output/output_file.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <ctime>
#include <iostream>
#include <span>

namespace pelt::reproduce {
namespace {

using methods::MethodKind;

constexpr std::array kDescribed = {methods::kOnDemand, methods::kEager,   lab::kRigid,
                                   methods::kPaper,    lab::kPaperEager,  lab::kPaperRigid,
                                   lab::kHybrid,       lab::kAabbRefit,   lab::kAabbRebuild,
                                   lab::kHash,         lab::kHashOverlap, lab::kBdTree};

Table described_methods() {
  Table table = {
      "methods",
      "The methods, by their names in this report",
      {{"method", "method"}, {"what", "what it does"}},
      {},
      "All methods use the same exact test of triangles and give the same contacts. \"Rigid\" "
      "is a baseline rather than a method: building its trees is not timed."};
  for (const MethodKind method : kDescribed)
    table.rows.push_back({title_of(method), description_of(method)});
  return table;
}

constexpr std::size_t kLastRow = SIZE_MAX;

/// A cell of one of the report's tables.
struct Place {
  const char* table;
  std::size_t row;
  const char* key;
};

/// The speed-up of refitting on demand over refitting bottom-up: in the paper, for the paper's
/// method here, and for Pelt over Pelt eager.
struct Claim {
  const char* what;
  Place printed, here, pelt;
};

/// A claim about a scene, from a row of its comparisons.
constexpr Claim scene_claim(const char* what, const char* table, std::size_t row) {
  return {
      what, {table, row, "paper_speed_up"}, {table, row, "speed_up"}, {table, row + 3, "speed_up"}};
}

constexpr Claim dwarves_claim(const char* what, const char* table) {
  return {what,
          {table, kLastRow, "printed_speed_up"},
          {table, kLastRow, "paper_speed_up"},
          {table, kLastRow, "speed_up"}};
}

constexpr Claim kClaims[] = {
    scene_claim("two men who walk towards each other", "two_men_ratios", 0),
    scene_claim("two creatures through each other", "worst_case_ratios", 0),
    scene_claim("the same, first contact only", "worst_case_ratios", 5),
    scene_claim("a crowd of fifty", "crowd_ratios", 0),
    dwarves_claim("dwarves apart, after the last subdivision", "dwarves_apart"),
    dwarves_claim("intersecting dwarves, after the last subdivision", "dwarves_interfering")};

const Table* find_table(std::span<const Section> sections, std::string_view id) {
  for (const Section& section : sections)
    for (const Table& table : section.tables)
      if (table.id == id) return &table;
  return nullptr;
}

Cell cell_at(const Table& table, const Place& place) {
  const std::size_t row = place.row == kLastRow ? table.rows.size() - 1 : place.row;
  return table.rows[row][column_of(table, place.key)];
}

Table claim_table(std::span<const Section> sections) {
  Table table = {"claims",
                 "Speed-up of refitting on demand over refitting everything",
                 {{"what", "scene"},
                  {"printed", "in the paper"},
                  {"here", "paper on demand against paper bottom-up, here"},
                  {"pelt", "Pelt against Pelt eager"}},
                 {},
                 "The sections below have the details of all these figures."};
  for (const Claim& claim : kClaims)
    if (const Table* const source = find_table(sections, claim.here.table))
      table.rows.push_back({claim.what, cell_at(*source, claim.printed),
                            cell_at(*source, claim.here), cell_at(*source, claim.pelt)});
  return table;
}

/// The first section of the report: describes each method, and compares the paper's claims with the
/// tables of `sections`. Leaves out claims whose section is missing.
Section summary(std::span<const Section> sections) {
  Section section;
  section.id = "summary";
  section.title = "The paper's claims today";
  section.text = {
      "The paper compares refitting on demand with bottom-up refitting of the same tree of "
      "spheres. "
      "This report measures both as described there, and both again with Pelt's tree of boxes, as "
      "fast as we can make them. The second pair shows the gain of refitting on demand today."};
  if (Table claims = claim_table(sections); !claims.rows.empty())
    section.tables.push_back(std::move(claims));
  section.tables.push_back(described_methods());
  return section;
}

}  // namespace

}  // namespace pelt::reproduce

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
  report.sections.insert(report.sections.begin(), reproduce::summary(report.sections));
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

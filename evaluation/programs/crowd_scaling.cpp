/// Measures how the time of a frame and the memory grow with a crowd: 100 to 10,000 walking
/// instances of a character, or the instances of a scene. Prints the best of several runs, because
/// other programs may use the machine. scripts/plot-crowd-growth draws the table.

#include "evaluation/bench/csv.hpp"
#include "evaluation/programs/crowd.hpp"
#include "evaluation/programs/program.hpp"
#include "scenes/scene.hpp"
#include "tools/pelt/output/output_conflicts.hpp"
#include "tools/pelt/output/output_file.hpp"
#include "tools/pelt/output/process.hpp"

#include <iostream>
#include <string>

#include <sys/resource.h>

namespace pelt::programs {
namespace {

struct Arguments {
  std::string input, csv;
  double metre = 0;
  std::uint32_t most = 10000, runs = 3;
};

/// The generated character needs more space, because it spreads its arms.
constexpr double kMetreOfGenerated = 1.9;

double megabytes(std::size_t bytes) { return static_cast<double>(bytes) / (1 << 20); }

/// Peak memory of the process.
std::size_t process_bytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::size_t>(usage.ru_maxrss) * 1024;
}

std::uint64_t triangles_of(const CrowdJob& job) {
  std::uint64_t triangles = 0;
  for (const SkinnedModel& model : job.models) triangles += model.triangle_count();
  return triangles;
}

/// Prints rows as they are measured, and stores them for the file of --csv.
class Measured {
 public:
  /// Measures one number of instances with each number of threads. The first run is a warm-up.
  void measure(const CrowdJob& job, std::uint32_t runs) {
    CrowdRun run(job);
    run.run(2);
    for (const std::uint32_t threads : {1u, 2u}) {
      const CrowdTiming best = run.best_of(runs, threads);
      rows_.push_back({{"instances", job.models.size()},
                       {"triangles", triangles_of(job)},
                       {"threads", threads},
                       {"frame_ms", best.frame_ms},
                       {"palettes_ms", best.palettes_ms},
                       {"candidate_pairs", best.stats.candidate_pairs},
                       {"touching_pairs", best.stats.intersecting_pairs},
                       {"contacts", best.contacts},
                       {"crowd_mb", megabytes(run.memory_bytes())},
                       {"process_mb", megabytes(process_bytes())}});
      printed_.write(rows_.back());
      std::cout.flush();
    }
  }

  void write(std::ostream& out) const {
    lab::CsvWriter table(out);
    for (const tools::bench::Row& row : rows_) table.write(row);
  }

 private:
  lab::CsvWriter printed_ = lab::CsvWriter(std::cout);
  std::vector<tools::bench::Row> rows_;
};

Result<SkinnedModel> build(const asset::Asset& asset) {
  const std::vector<Matrix4> samples = WalkPhases(asset).samples();
  return build_model(asset.mesh(),
                     {.off_weights = OffWeights::renormalise, .sample_palettes = samples});
}

Result<void> measure_scene(const Arguments& arguments, Measured& measured) {
  const Result<scenes::Scene> scene = scenes::load_scene(arguments.input);
  if (!scene) return scene.error();
  std::vector<SkinnedModel> models;
  for (const scenes::Character& character : scene->characters) {
    const Result<SkinnedModel> model = build(character.asset);
    if (!model) return model.error();
    models.push_back(*model);
  }
  CrowdJob job;
  job.frame_count = scene->frame_count;
  for (const scenes::Instance& instance : scene->instances)
    job.models.push_back(models[instance.character]);
  asset::SampleScratch scratch;
  job.pose = [&](std::uint32_t frame, std::vector<Matrix4>& palettes) {
    palettes.clear();
    for (std::uint32_t i = 0; i < scene->instances.size(); ++i) {
      const std::size_t first = palettes.size();
      palettes.resize(first + job.models[i].joint_count());
      instance_palette(*scene, i, frame, scratch, std::span(palettes).subspan(first));
    }
  };
  measured.measure(job, arguments.runs);
  return {};
}

Result<void> measure_character(const Arguments& arguments, Measured& measured) {
  const bool is_generated = arguments.input.empty();
  const Result<scenes::Character> character =
      is_generated ? scenes::generate_character(scenes::CreatureOptions{})
                   : scenes::load_character(arguments.input);
  if (!character) return character.error();
  const Result<SkinnedModel> model = build(character->asset);
  if (!model) return model.error();
  const WalkPhases phases(character->asset);
  const double metre = arguments.metre > 0 ? arguments.metre : is_generated ? kMetreOfGenerated : 1;
  for (const std::uint32_t count : {100u, 300u, 1000u, 3000u, 10000u}) {
    if (count > arguments.most) break;
    const WalkingCrowd crowd(phases, count, metre);
    CrowdJob job;
    job.models.assign(count, *model);
    job.frame_count = 15;
    job.pose = [&](std::uint32_t frame, std::vector<Matrix4>& palettes) {
      crowd.pose(frame, palettes);
    };
    measured.measure(job, arguments.runs);
  }
  return {};
}

Result<void> check_csv(const Arguments& arguments) {
  std::vector<tools::output::InputFile> inputs;
  if (!arguments.input.empty()) inputs.push_back({arguments.input, "the input"});
  const tools::output::NamedOutput csv = {"--csv", arguments.csv};
  return tools::output::check_outputs({&csv, 1}, inputs);
}

constexpr Program kProgram = {
    "crowd_scaling",
    "Measure how the time of a frame grows with a crowd, on one thread and on two"};

int run(const Arguments& arguments) {
  if (const auto checked = check_csv(arguments); !checked)
    return fail(kProgram, checked.error().message);
  tools::output::OutputFile csv;
  if (const auto opened = csv.open(arguments.csv); !opened)
    return fail(kProgram, opened.error().message);
  Measured measured;
  const Result<void> done = arguments.input.ends_with(".json")
                                ? measure_scene(arguments, measured)
                                : measure_character(arguments, measured);
  if (!done) return fail(kProgram, done.error().message);
  if (csv.stream() != nullptr) measured.write(*csv.stream());
  const Result<void> written = csv.close();
  return written ? 0 : fail(kProgram, written.error().message);
}

int parse_and_run(int argc, char** argv) {
  CLI::App app(kProgram.description);
  Arguments arguments;
  app.add_option(
      "INPUT", arguments.input,
      "A character (.glb) that walks, or a scene (.json); default: the generated character");
  app.add_option("--metre", arguments.metre, "Length of a metre in units of the character");
  app.add_option("--most", arguments.most, "Largest number of instances")->capture_default_str();
  app.add_option("--runs", arguments.runs, "Runs of which the best counts")->capture_default_str();
  app.add_option("--csv", arguments.csv, "Write the table")->type_name("FILE");
  CLI11_PARSE(app, argc, argv);
  tools::output::remove_unfinished_files_on_signals();
  return run(arguments);
}

}  // namespace
}  // namespace pelt::programs

int main(int argc, char** argv) { return pelt::programs::parse_and_run(argc, argv); }

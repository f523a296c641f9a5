#include "tools/pelt/bench/moving_report.hpp"

#include "asset/printable.hpp"
#include "tools/pelt/bench/bench_measure.hpp"
#include "tools/pelt/bench/bench_ratios.hpp"
#include "tools/pelt/bench/machine_json.hpp"
#include "tools/pelt/bench/moving_ratios.hpp"
#include "tools/pelt/output/json_text.hpp"
#include "tools/pelt/output/text.hpp"
#include "tools/pelt/scene/json_lines.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <iomanip>

namespace pelt::tools::bench {
namespace {

using nlohmann::ordered_json;

constexpr int kMethodColumn = 12, kFigureColumn = 14;

void print_columns(const std::string& name, const std::vector<std::string>& cells,
                   std::ostream& out) {
  out << std::left << std::setw(kMethodColumn) << name << std::right;
  for (const std::string& cell : cells) out << std::setw(kFigureColumn) << cell;
  out << '\n';
}

/// Pairs of triangles that each stage has decided.
struct Stages {
  explicit Stages(const MovingStats& work)
      : pairs(work.triangle_pairs),
        in_float(work.triangle_pairs - std::min(work.double_pairs, work.triangle_pairs)),
        in_double(work.double_pairs - work.exact_pairs),
        in_exact(work.exact_pairs) {}

  std::uint64_t pairs, in_float, in_double, in_exact;
};

/// Time of a query per pair of triangles. Nullopt if none was tested, and for queries that spend
/// most of their time elsewhere.
std::optional<double> ns_per_pair(const MovingSceneFigures& scene, const MovingFigures& figures) {
  const bool tests_all =
      figures.question == MovingQuestion::pairs || figures.question == MovingQuestion::times;
  const auto pairs = static_cast<double>(figures.answer.work.triangle_pairs);
  const double query_us = figures.times.mean_us - figures.times.mean_update_us;
  if (!tests_all || pairs == 0) return std::nullopt;
  return 1000 * query_us * static_cast<double>(scene.steps) / pairs;
}

void print_scene(const MovingSceneFigures& scene, std::ostream& out) {
  out << asset::printable(scene.scene) << ": " << output::with_commas(scene.triangles)
      << " triangles, " << output::counted(scene.steps, "step") << " between frames\n";
  if (scene.repetitions < kEnoughRepetitions)
    out << "rough measurement: " << output::counted(scene.repetitions, "repetition")
        << " per step; use " << kEnoughRepetitions << " or more to reduce noise\n";
  out << "all " << output::with_commas(scene.vertices)
      << " vertices skinned once: " << output::fixed(scene.skinning_us, 1) << " us per step\n";
}

const char* words_of(MovingQuestion question) {
  constexpr std::array kWords = {
      "the contacts at the end of the step (discrete)", "which triangles touch during the step",
      "the same, with times and features", "the first contact of each pair of instances",
      "whether each pair of instances touches during the step"};
  return kWords[static_cast<std::size_t>(question)];
}

void print_head(const MovingSceneFigures& scene, const MovingFigures& figures, std::ostream& out) {
  out << "\nquery " << name_of(figures.question) << ": " << words_of(figures.question)
      << "; thread time, median of " << scene.repetitions << "; "
      << output::with_commas(figures.answer.contacts) << " in "
      << output::counted(figures.answer.steps_in_contact, "step") << "; hash "
      << output::hex16(figures.answer.hash) << " by every method\n";
  print_columns("method",
                {"mean us", "median us", "in contact", "95 %", "update", "query", "of collide",
                 "of on_demand"},
                out);
}

void print_row(const MovingSceneFigures& scene, const MovingFigures& figures, std::ostream& out) {
  const MovingTimes& times = figures.times;
  print_columns(figures.method,
                {output::fixed(times.mean_us, 1), output::fixed(times.median_us, 1),
                 times.steps_in_contact > 0 ? output::fixed(times.mean_contact_us, 1) : "-",
                 output::fixed(times.p95_us, 1), output::fixed(times.mean_update_us, 1),
                 output::fixed(times.mean_us - times.mean_update_us, 1),
                 in_words(of_collide(scene, figures)), in_words(of_on_demand(scene, figures))},
                out);
}

std::string share_of(std::uint64_t part, std::uint64_t all) {
  if (all == 0) return "-";
  return output::fixed(100 * static_cast<double>(part) / static_cast<double>(all), 2) + " %";
}

void print_stages(const MovingSceneFigures& scene, const MovingFigures& figures,
                  std::ostream& out) {
  const Stages stages(figures.answer.work);
  const std::optional<double> ns = ns_per_pair(scene, figures);
  print_columns(figures.method,
                {name_of(figures.question), output::with_commas(stages.pairs),
                 share_of(stages.in_float, stages.pairs), share_of(stages.in_double, stages.pairs),
                 output::with_commas(stages.in_exact), share_of(stages.in_exact, stages.pairs),
                 ns ? output::fixed(*ns, 0) : "-"},
                out);
}

/// Prints by which arithmetic the pairs of triangles were decided.
void print_all_stages(const MovingSceneFigures& scene, std::ostream& out) {
  out << "\npairs of triangles, all steps, and the share that each arithmetic decides\n";
  print_columns("method", {"query", "pairs", "float", "double", "exact", "exact", "ns per pair"},
                out);
  for (const MovingFigures& figures : scene.figures)
    if (figures.question != MovingQuestion::collide) print_stages(scene, figures, out);
  out << '\n';
}

ordered_json optional_json(const std::optional<double>& value) {
  return value ? ordered_json(*value) : ordered_json();
}

ordered_json counters_of(const MovingStats& work) {
  ordered_json counters = scene::counters_json(work);
  counters["double_pairs"] = work.double_pairs;
  counters["exact_pairs"] = work.exact_pairs;
  return counters;
}

ordered_json method_json(const MovingSceneFigures& scene, const MovingFigures& figures) {
  const MovingTimes& times = figures.times;
  const ordered_json in_contact =
      times.steps_in_contact > 0 ? ordered_json(times.mean_contact_us) : ordered_json();
  return {{"method", figures.method},
          {"query", name_of(figures.question)},
          {"mean_us", times.mean_us},
          {"median_us", times.median_us},
          {"mean_contact_us", in_contact},
          {"p95_us", times.p95_us},
          {"mean_update_us", times.mean_update_us},
          {"of_collide", optional_json(of_collide(scene, figures))},
          {"ns_per_pair", optional_json(ns_per_pair(scene, figures))},
          {"steps_in_contact", figures.answer.steps_in_contact},
          {"contacts", figures.answer.contacts},
          {"hash", output::hex16(figures.answer.hash)},
          {"counters", counters_of(figures.answer.work)}};
}

ordered_json scene_json(const MovingSceneFigures& scene) {
  ordered_json methods = ordered_json::array();
  for (const MovingFigures& figures : scene.figures) methods.push_back(method_json(scene, figures));
  return {{"scene", scene.scene},
          {"triangles", scene.triangles},
          {"steps", scene.steps},
          {"repetitions", scene.repetitions},
          {"skinning", {{"vertices", scene.vertices}, {"mean_us", scene.skinning_us}}},
          {"methods", std::move(methods)}};
}

}  // namespace

void print_moving_figures(const MovingSceneFigures& scene, std::ostream& out) {
  print_scene(scene, out);
  const MovingFigures* before = nullptr;
  for (const MovingFigures& figures : scene.figures) {
    if (before == nullptr || before->question != figures.question) print_head(scene, figures, out);
    print_row(scene, figures, out);
    before = &figures;
  }
  print_all_stages(scene, out);
}

std::string moving_figures_json(const std::vector<MovingSceneFigures>& scenes) {
  ordered_json all = ordered_json::array();
  for (const MovingSceneFigures& scene : scenes) all.push_back(scene_json(scene));
  const ordered_json figures = {{"format", "pelt-bench-moving"},
                                {"version", 1},
                                {"machine", machine_json()},
                                {"scenes", std::move(all)}};
  return output::json_text(figures, 2) + "\n";
}

}  // namespace pelt::tools::bench

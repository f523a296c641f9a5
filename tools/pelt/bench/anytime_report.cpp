#include "tools/pelt/bench/anytime_report.hpp"

#include "asset/printable.hpp"
#include "tools/pelt/bench/bench_measure.hpp"
#include "tools/pelt/bench/bench_ratios.hpp"
#include "tools/pelt/bench/machine_json.hpp"
#include "tools/pelt/methods/anytime_methods.hpp"
#include "tools/pelt/output/json_text.hpp"
#include "tools/pelt/output/text.hpp"

#include <nlohmann/json.hpp>

#include <functional>
#include <iomanip>

namespace pelt::tools::bench {
namespace {

using nlohmann::ordered_json;

constexpr int kNameWidth = 14, kShareWidth = 9, kCountWidth = 14;

/// About three digits.
std::string in_short(double value) {
  if (value >= 100) return output::fixed(value, 0);
  if (value >= 10) return output::fixed(value, 1);
  if (value >= 1) return output::fixed(value, 2);
  return output::fixed(value, value >= 0.01 || value == 0 ? 3 : 5);
}

std::string in_per_cent(double share) { return in_short(100 * share); }

void print_columns(const std::string& name, const std::vector<std::string>& cells, int width,
                   std::ostream& out) {
  out << std::left << std::setw(kNameWidth) << name << std::right;
  for (const std::string& cell : cells) out << std::setw(width) << cell;
  out << '\n';
}

std::vector<std::string> names_of_rungs() {
  std::vector<std::string> names;
  names.reserve(kAnytimeRungs.size());
  for (const double share : kAnytimeRungs) names.push_back(output::fixed(100 * share, 0) + " %");
  return names;
}

/// A table with a row for each method and a column for each rung.
struct RungTable {
  std::string title;
  std::vector<AnytimeRung> AnytimeMethodFigures::*rungs;
  std::function<std::string(const AnytimeRung&)> cell;
  double AnytimeMethodFigures::*area = nullptr;  ///< appended with its ratio, unless null
};

void print_table(const AnytimeSceneFigures& scene, const RungTable& table, std::ostream& out) {
  out << '\n' << table.title << '\n';
  std::vector<std::string> head = names_of_rungs();
  if (table.area) head.insert(head.end(), {"area", "of paper"});
  print_columns("method", head, kShareWidth, out);
  for (const AnytimeMethodFigures& method : scene.methods) {
    std::vector<std::string> cells;
    for (const AnytimeRung& rung : method.*table.rungs) cells.push_back(table.cell(rung));
    if (table.area) {
      cells.push_back(output::fixed(method.*table.area, 3));
      cells.push_back(in_words(of_paper(scene, method, table.area)));
    }
    print_columns(method.method, cells, kShareWidth, out);
  }
}

void print_scene(const AnytimeSceneFigures& scene, std::ostream& out) {
  out << asset::printable(scene.scene) << ": " << output::with_commas(scene.triangles)
      << " triangles, " << output::counted(scene.pairs, "pair") << " of instances in contact in "
      << output::counted(scene.frames, "frame") << '\n';
  if (scene.repetitions < kEnoughRepetitions)
    out << "rough measurement: " << output::counted(scene.repetitions, "repetition")
        << " per pair; use " << kEnoughRepetitions << " or more to reduce noise\n";
  out << output::with_commas(scene.contacts) << " contacts, hash " << output::hex16(scene.hash)
      << " by collide and by every method when complete\n"
      << "means over the pairs; thread time, median of " << scene.repetitions << '\n';
}

void print_ends(const AnytimeSceneFigures& scene, std::ostream& out) {
  out << "\ncomplete\n";
  print_columns("method", {"units of work", "longest step", "us", "of collide"}, kCountWidth, out);
  print_columns("collide", {"-", "-", output::fixed(scene.collide_us, 1), "1.00"}, kCountWidth,
                out);
  for (const AnytimeMethodFigures& method : scene.methods)
    print_columns(method.method,
                  {output::fixed(method.work, 0), output::with_commas(method.longest_step),
                   output::fixed(method.complete_us, 1),
                   output::fixed(method.complete_us / scene.collide_us, 2)},
                  kCountWidth, out);
  out << '\n';
}

ordered_json rungs_json(const std::vector<AnytimeRung>& rungs) {
  ordered_json all = ordered_json::array();
  for (const AnytimeRung& rung : rungs)
    all.push_back({{"share", rung.share},
                   {"time", rung.time},
                   {"listed", rung.known.listed},
                   {"undecided", rung.known.undecided},
                   {"resolution", rung.known.resolution}});
  return all;
}

ordered_json method_json(const AnytimeMethodFigures& method) {
  return {{"method", method.method},
          {"work", method.work},
          {"longest_step", method.longest_step},
          {"mean_us", method.complete_us},
          {"area_over_work", method.area_over_work},
          {"area_over_time", method.area_over_time},
          {"over_work", rungs_json(method.over_work)},
          {"over_time", rungs_json(method.over_time)},
          {"course", rungs_json(method.course)}};
}

ordered_json scene_json(const AnytimeSceneFigures& scene) {
  ordered_json methods = ordered_json::array();
  for (const AnytimeMethodFigures& method : scene.methods) methods.push_back(method_json(method));
  return {{"scene", scene.scene},
          {"triangles", scene.triangles},
          {"frames_in_contact", scene.frames},
          {"pairs", scene.pairs},
          {"contacts", scene.contacts},
          {"hash", output::hex16(scene.hash)},
          {"repetitions", scene.repetitions},
          {"collide_us", scene.collide_us},
          {"methods", std::move(methods)}};
}

}  // namespace

std::optional<double> of_paper(const AnytimeSceneFigures& scene,
                               const AnytimeMethodFigures& figures,
                               double AnytimeMethodFigures::*area) {
  const AnytimeMethodFigures* paper = find_method(scene, methods::kAnytimePaper.name);
  if (!paper || !(paper->*area > 0)) return std::nullopt;
  return figures.*area / (paper->*area);
}

void print_anytime_figures(const AnytimeSceneFigures& scene, std::ostream& out) {
  const auto over_work = &AnytimeMethodFigures::over_work;
  const auto over_time = &AnytimeMethodFigures::over_time;
  const auto listed = [](const AnytimeRung& rung) { return in_per_cent(rung.known.listed); };
  const auto undecided = [](const AnytimeRung& rung) { return in_per_cent(rung.known.undecided); };
  const auto longest = [](const AnytimeRung& rung) { return in_short(rung.known.resolution); };
  const auto time = [](const AnytimeRung& rung) { return in_per_cent(rung.time); };
  print_scene(scene, out);
  const RungTable tables[] = {
      {"contacts listed [%] after a share of the method's own work", over_work, listed,
       &AnytimeMethodFigures::area_over_work},
      {"pairs of triangles undecided [%]", over_work, undecided},
      {"longest side of an open region [model units]", over_work, longest},
      {"time [% of a complete search in the order contacts]", over_work, time},
      {"contacts listed [%] after the same time [% of a complete search in the order contacts]",
       over_time, listed, &AnytimeMethodFigures::area_over_time},
      {"longest side of an open region [model units] after the same time", over_time, longest}};
  for (const RungTable& table : tables) print_table(scene, table, out);
  print_ends(scene, out);
}

std::string anytime_figures_json(const std::vector<AnytimeSceneFigures>& scenes) {
  ordered_json all = ordered_json::array();
  for (const AnytimeSceneFigures& scene : scenes) all.push_back(scene_json(scene));
  const ordered_json figures = {{"format", "pelt-bench-anytime"},
                                {"version", 1},
                                {"machine", machine_json()},
                                {"scenes", std::move(all)}};
  return output::json_text(figures, 2) + "\n";
}

}  // namespace pelt::tools::bench

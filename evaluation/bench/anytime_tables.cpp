/// The figures of `pelt-lab bench --anytime` as tables and as JSON.

#include "evaluation/bench/anytime_bench.hpp"
#include "text/format.hpp"
#include "text/printable.hpp"
#include "tools/pelt/bench/measure.hpp"

#include <functional>
#include <optional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace pelt::lab {
namespace {

namespace bench = tools::bench;
using bench::Row;

/// About three digits.
std::string in_short(double value) {
  if (value >= 100) return text::fixed(value, 0);
  if (value >= 10) return text::fixed(value, 1);
  if (value >= 1) return text::fixed(value, 2);
  return text::fixed(value, value >= 0.01 || value == 0 ? 3 : 5);
}

std::string in_per_cent(double share) { return in_short(100 * share); }

/// A table with a row for each method and a column for each rung.
struct RungTable {
  std::string title;
  std::vector<AnytimeRung> AnytimeMethodFigures::*rungs;
  std::function<std::string(const AnytimeRung&)> cell;
  double AnytimeMethodFigures::*area = nullptr;  ///< appended with its ratio, unless null
};

void print_rungs(const AnytimeSceneFigures& scene, const RungTable& table, std::ostream& out) {
  std::vector<std::string> titles;
  for (const double share : kAnytimeRungs) titles.push_back(text::fixed(100 * share, 0) + " %");
  std::vector<bench::Column> columns = {{"method", "method"}};
  for (const std::string& title : titles) columns.push_back({title.c_str(), title.c_str()});
  columns.push_back({"area", "area", 3});
  columns.push_back({"of_paper", "of paper", 2});
  std::vector<Row> rows;
  for (const AnytimeMethodFigures& method : scene.methods) {
    Row& row = rows.emplace_back(Row{{"method", method.method}});
    for (std::size_t i = 0; i < titles.size(); ++i)
      row[titles[i]] = table.cell((method.*table.rungs)[i]);
    if (!table.area) continue;
    row["area"] = method.*table.area;
    row["of_paper"] = bench::value_or_null(of_paper(scene, method, table.area));
  }
  out << '\n' << table.title << '\n';
  bench::print_table(columns, rows, out, {14, 9});
}

void print_scene(const AnytimeSceneFigures& scene, std::ostream& out) {
  out << text::printable(scene.scene) << ": " << text::with_commas(scene.triangles)
      << " triangles, " << text::counted(scene.pairs, "pair") << " of instances in contact in "
      << text::counted(scene.frames, "frame") << '\n';
  bench::print_repetitions(scene.repetitions, "pair", out);
  out << text::with_commas(scene.contacts) << " contacts, hash " << text::hex16(scene.hash)
      << " by collide and by every method when complete\n"
      << "means over the pairs; thread time, median of " << scene.repetitions << '\n';
}

void print_ends(const AnytimeSceneFigures& scene, std::ostream& out) {
  constexpr bench::Column kColumns[] = {{"method", "method"},
                                        {"work", "units of work", 0},
                                        {"longest_step", "longest step"},
                                        {"mean_us", "us"},
                                        {"of_collide", "of collide", 2}};
  std::vector<Row> rows = {{{"method", "collide"},
                            {"work", nullptr},
                            {"longest_step", nullptr},
                            {"mean_us", scene.collide_us},
                            {"of_collide", 1.0}}};
  for (const AnytimeMethodFigures& method : scene.methods)
    rows.push_back({{"method", method.method},
                    {"work", method.work},
                    {"longest_step", method.longest_step},
                    {"mean_us", method.complete_us},
                    {"of_collide", method.complete_us / scene.collide_us}});
  out << "\ncomplete\n";
  bench::print_table(kColumns, rows, out, {14, 14});
  out << '\n';
}

Row rungs_json(const std::vector<AnytimeRung>& rungs) {
  Row all = Row::array();
  for (const AnytimeRung& rung : rungs)
    all.push_back({{"share", rung.share},
                   {"time", rung.time},
                   {"listed", rung.known.listed},
                   {"undecided", rung.known.undecided},
                   {"resolution", rung.known.resolution}});
  return all;
}

Row method_json(const AnytimeMethodFigures& method) {
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

}  // namespace

std::optional<double> of_paper(const AnytimeSceneFigures& scene,
                               const AnytimeMethodFigures& figures,
                               double AnytimeMethodFigures::*area) {
  const AnytimeMethodFigures* paper = find_method(scene, kAnytimePaper.name);
  if (!paper || !(paper->*area > 0)) return std::nullopt;
  return figures.*area / (paper->*area);
}

void print_figures(const AnytimeSceneFigures& scene, std::ostream& out) {
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
  for (const RungTable& table : tables) print_rungs(scene, table, out);
  print_ends(scene, out);
}

Row scene_json(const AnytimeSceneFigures& scene) {
  Row methods = Row::array();
  for (const AnytimeMethodFigures& method : scene.methods) methods.push_back(method_json(method));
  return {{"scene", scene.scene},
          {"triangles", scene.triangles},
          {"frames_in_contact", scene.frames},
          {"pairs", scene.pairs},
          {"contacts", scene.contacts},
          {"hash", text::hex16(scene.hash)},
          {"repetitions", scene.repetitions},
          {"collide_us", scene.collide_us},
          {"methods", std::move(methods)}};
}

}  // namespace pelt::lab

/// The figures of `pelt-lab bench --moving` as tables and as JSON.

#include "evaluation/bench/moving_bench.hpp"
#include "text/format.hpp"
#include "text/printable.hpp"
#include "tools/pelt/scene/json_lines.hpp"

#include <algorithm>
#include <array>
#include <ostream>
#include <string>
#include <vector>

namespace pelt::lab {
namespace {

namespace bench = tools::bench;
using bench::Row;

/// Time of a query per pair of triangles. Null if none was tested, and for queries that spend most
/// of their time elsewhere.
Row ns_per_pair(const MovingSceneFigures& scene, const MovingFigures& figures) {
  const bool tests_all =
      figures.question == MovingQuestion::pairs || figures.question == MovingQuestion::times;
  const auto pairs = static_cast<double>(figures.answer.work.triangle_pairs);
  if (!tests_all || pairs == 0) return {};
  return 1000 * figures.times.mean_query_us() * static_cast<double>(scene.steps) / pairs;
}

Row counters_of(const MovingStats& work) {
  Row counters = scene::counters_json(work);
  counters["double_pairs"] = work.double_pairs;
  counters["exact_pairs"] = work.exact_pairs;
  return counters;
}

/// The values of --json; the ratio is added when all rows are known.
Row method_json(const MovingSceneFigures& scene, const MovingFigures& figures) {
  const Times& times = figures.times;
  return {{"method", figures.method},
          {"query", name_of(figures.question)},
          {"mean_us", times.mean_us},
          {"median_us", times.median_us},
          {"mean_contact_us", times.frames_in_contact > 0 ? Row(times.mean_contact_us) : Row()},
          {"p95_us", times.p95_us},
          {"mean_update_us", times.mean_update_us},
          {"of_collide", Row()},
          {"ns_per_pair", ns_per_pair(scene, figures)},
          {"steps_in_contact", figures.answer.steps_in_contact},
          {"contacts", figures.answer.contacts},
          {"hash", text::hex16(figures.answer.hash)},
          {"counters", counters_of(figures.answer.work)}};
}

std::vector<Row> method_rows(const MovingSceneFigures& scene) {
  std::vector<Row> rows;
  for (const MovingFigures& figures : scene.figures) rows.push_back(method_json(scene, figures));
  for (Row& row : rows) row["of_collide"] = bench::ratio_to(kMovingYardsticks[0], rows, row);
  return rows;
}

void print_scene(const MovingSceneFigures& scene, std::ostream& out) {
  out << text::printable(scene.scene) << ": " << text::with_commas(scene.triangles)
      << " triangles, " << text::counted(scene.steps, "step") << " between frames\n";
  bench::print_repetitions(scene.repetitions, "step", out);
  out << "all " << text::with_commas(scene.skinning.vertices)
      << " vertices skinned once: " << text::fixed(scene.skinning.mean_us, 1) << " us per step\n";
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
      << text::with_commas(figures.answer.contacts) << " in "
      << text::counted(figures.answer.steps_in_contact, "step") << "; hash "
      << text::hex16(figures.answer.hash) << " by every method\n";
}

/// Prints a table for each question.
void print_times(const MovingSceneFigures& scene, std::ostream& out) {
  constexpr bench::Column kColumns[] = {{"method", "method"},
                                        {"mean_us", "mean us"},
                                        {"median_us", "median us"},
                                        {"mean_contact_us", "in contact"},
                                        {"p95_us", "95 %"},
                                        {"mean_update_us", "update"},
                                        {"query_us", "query"},
                                        {"of_collide", "of collide", 2},
                                        {"of_on_demand", "of on_demand", 2}};
  const std::vector<Row> rows = method_rows(scene);
  for (std::size_t begin = 0, end = 0; begin < rows.size(); begin = end) {
    std::vector<Row> group;
    for (; end < rows.size() && rows[end]["query"] == rows[begin]["query"]; ++end) {
      group.push_back(rows[end]);
      group.back()["query_us"] = scene.figures[end].times.mean_query_us();
      group.back()["of_on_demand"] = bench::ratio_to(kMovingYardsticks[1], rows, rows[end]);
    }
    print_head(scene, scene.figures[begin], out);
    bench::print_table(kColumns, group, out, {12, 14});
  }
}

/// Prints by which arithmetic the pairs of triangles were decided.
void print_stages(const MovingSceneFigures& scene, std::ostream& out) {
  constexpr bench::Column kColumns[] = {{"method", "method"}, {"query", "query"},
                                        {"pairs", "pairs"},   {"float", "float"},
                                        {"double", "double"}, {"exact_pairs", "exact"},
                                        {"exact", "exact"},   {"ns_per_pair", "ns per pair", 0}};
  std::vector<Row> rows;
  for (const MovingFigures& figures : scene.figures) {
    if (figures.question == MovingQuestion::collide) continue;
    const MovingStats& work = figures.answer.work;
    const auto share = [&](std::uint64_t part) {
      if (work.triangle_pairs == 0) return Row();
      return Row(
          text::fixed(100 * static_cast<double>(part) / static_cast<double>(work.triangle_pairs),
                      2) +
          " %");
    };
    rows.push_back(
        {{"method", figures.method},
         {"query", name_of(figures.question)},
         {"pairs", work.triangle_pairs},
         {"float", share(work.triangle_pairs - std::min(work.double_pairs, work.triangle_pairs))},
         {"double", share(work.double_pairs - work.exact_pairs)},
         {"exact_pairs", work.exact_pairs},
         {"exact", share(work.exact_pairs)},
         {"ns_per_pair", ns_per_pair(scene, figures)}});
  }
  if (!rows.empty()) {
    out << "\npairs of triangles, all steps, and the share that each arithmetic decides\n";
    bench::print_table(kColumns, rows, out, {12, 14});
  }
  out << '\n';
}

}  // namespace

void print_figures(const MovingSceneFigures& scene, std::ostream& out) {
  print_scene(scene, out);
  print_times(scene, out);
  print_stages(scene, out);
}

Row scene_json(const MovingSceneFigures& scene) {
  return {
      {"scene", scene.scene},
      {"triangles", scene.triangles},
      {"steps", scene.steps},
      {"repetitions", scene.repetitions},
      {"skinning", {{"vertices", scene.skinning.vertices}, {"mean_us", scene.skinning.mean_us}}},
      {"methods", method_rows(scene)}};
}

}  // namespace pelt::lab

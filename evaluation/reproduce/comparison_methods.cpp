#include "evaluation/reproduce/comparison_methods.hpp"

#include "base/assert.hpp"
#include "evaluation/methods/posed_mesh_adapter.hpp"
#include "evaluation/reproduce/method_title.hpp"

#include <algorithm>

namespace pelt::reproduce {
namespace {

using methods::MethodKind;

constexpr std::array kTreesOnDemand = {methods::kOnDemand, methods::kEager, methods::kPaper,
                                       lab::kBdTree};
constexpr std::array kSkinningAll = {methods::kOnDemand, lab::kPaperEager,  lab::kHybrid,
                                     lab::kAabbRefit,    lab::kAabbRebuild, lab::kHash,
                                     lab::kHashOverlap};

bool is_measured(const tools::bench::SceneFigures& figures, MethodKind method) {
  return std::any_of(figures.figures.begin(), figures.figures.end(),
                     [&](const tools::bench::Figures& of) { return of.method == method.name; });
}

Chart chart_of(const Table& table, const char* family, const char* title,
               std::span<const MethodKind> methods) {
  Chart chart;
  chart.id = table.id + "_" + family;
  chart.title = table.title + ": " + title;
  chart.table = table.id;
  chart.y_title = "per frame [us]";
  for (const MethodKind method : methods) chart.y.push_back(time_key(method));
  return chart;
}

}  // namespace

std::string time_key(MethodKind method) { return std::string(method.name) + "_us"; }

Column time_column(MethodKind method) { return {time_key(method), title_of(method) + " [us]"}; }

Table times_table(const std::string& id, const std::string& title, std::vector<Column> first,
                  std::span<const MethodKind> methods, const std::string& note) {
  Table table = {id, title, std::move(first), {}, note};
  for (const MethodKind method : methods) table.columns.push_back(time_column(method));
  table.columns.push_back({"fastest", "fastest"});
  return table;
}

void append_times(const tools::bench::SceneFigures& figures, tools::bench::Question question,
                  std::span<const MethodKind> methods, std::vector<Cell>& row) {
  std::optional<MethodKind> fastest;
  for (const MethodKind method : methods) {
    row.push_back(is_measured(figures, method) ? mean_us(figures, method, question) : Cell());
    if (!row.back().figure) continue;
    if (!fastest || *row.back().figure < mean_us(figures, *fastest, question)) fastest = method;
  }
  PELT_ASSERT(fastest);
  row.push_back(title_of(*fastest));
}

std::string how_measured(const std::string& mean_of, const Conditions& conditions) {
  return mean_of + (mean_of.empty() ? "" : " ") + "Medians of " +
         std::to_string(conditions.is_quick ? 3 : 9) +
         " repetitions; one thread, hot caches; skinning is included.";
}

void add_with_charts(Table table, const std::string& x, Axes axes, std::optional<double> x_end,
                     Section& section) {
  for (Chart chart : {chart_of(table, "on_demand", "trees on demand", kTreesOnDemand),
                      chart_of(table, "skinning_all", "methods that skin all", kSkinningAll)}) {
    chart.x = x;
    chart.axes = axes;
    chart.x_end = x_end;
    section.charts.push_back(std::move(chart));
  }
  section.tables.push_back(std::move(table));
}

tools::bench::BenchMethod rival_method(const std::string& name, const MakeRival& make) {
  return {name, [make](std::span<const tools::scene::Collider> colliders) {
            return tools::scene::SceneQuery(colliders, lab::adapt(make()));
          }};
}

double figure_at(const Table& table, std::size_t row, const std::string& key) {
  const Cell& cell = table.rows[row][column_of(table, key)];
  PELT_ASSERT(cell.figure);
  return *cell.figure;
}

}  // namespace pelt::reproduce

#include "evaluation/reproduce/growth.hpp"

#include "evaluation/reproduce/power_law.hpp"
#include "scenes/creature.hpp"

#include <algorithm>

namespace pelt::reproduce {
namespace {

constexpr std::array<std::uint32_t, 7> kTriangles = {1000,   3162,   10000,  31623,
                                                     100000, 316228, 1000000};
constexpr std::array<std::uint32_t, 6> kJoints = {20, 25, 32, 40, 50, 64};
constexpr std::array<std::uint32_t, 8> kInstances = {2, 10, 32, 100, 316, 1000, 3162, 10000};
constexpr std::array<double, 10> kDistances = {1.2, 0.9, 0.8, 0.7, 0.6, 0.5, 0.4, 0.2, 0.1, 0};

/// All sizes; in a quick run only the first ones.
template <std::size_t kCount>
std::span<const std::uint32_t> chosen(const std::array<std::uint32_t, kCount>& sizes,
                                      std::size_t quick_count, const Conditions& conditions) {
  return std::span(sizes).first(conditions.is_quick ? quick_count : kCount);
}

bool has_column(const Table& table, const std::string& key) {
  return std::any_of(table.columns.begin(), table.columns.end(),
                     [&](const Column& column) { return column.key == key; });
}

/// The points of a column at the sizes where it was measured; empty if the table has no such
/// column.
std::vector<Measured> points_of(const Growth& growth, const std::string& key) {
  if (!has_column(growth.table, key)) return {};
  const std::size_t x = column_of(growth.table, growth.size), y = column_of(growth.table, key);
  std::vector<Measured> points;
  for (const std::vector<Cell>& row : growth.table.rows)
    if (row[y].figure) points.push_back({*row[x].figure, *row[y].figure});
  return points;
}

/// Only rows with contacts, because two separate bodies are another case than a crowd.
std::vector<Measured> points_in_contact(const Growth& growth, const std::string& key) {
  Growth in_contact = growth;
  std::erase_if(in_contact.table.rows, [&](const std::vector<Cell>& row) {
    return row[column_of(growth.table, "contacts")].figure == 0.0;
  });
  return points_of(in_contact, key);
}

Cell exponent_of(const Growth& growth, const std::string& key) {
  const std::vector<Measured> points = points_in_contact(growth, key);
  return points.size() < 2 ? Cell() : fitted_exponent(points);
}

/// "Pelt 5.12 to 7.21 us"
std::string rise_of(const Growth& growth, const GrowingMethod& method) {
  const auto points = points_of(growth, method.column().key);
  return std::string(method.name) + ' ' + shown(points.front().value) + " to " +
         shown(points.back().value) + " us";
}

/// "From 2 to 100 instances: Pelt 5.12 to 7.21 us, ..."
std::string text_of(const Growth& growth) {
  std::string rises;
  for (std::size_t i = 0; i < kPairMethods.size(); ++i)
    rises += (i == 0 ? ": " : ", ") + rise_of(growth, kGrowingMethods[i]);
  const auto points = points_of(growth, kGrowingMethods[0].column().key);
  return "From " + shown(points.front().size) + " to " + shown(points.back().size) + ' ' +
         growth.size + rises + '.';
}

std::string text_of_crowd(const Growth& instances) {
  const GrowingMethod& crowd = kGrowingMethods.back();
  const auto points = points_of(instances, crowd.column().key);
  return "The crowd queried as a whole: " + rise_of(instances, crowd) + " for " +
         shown(points.front().size) + " to " + shown(points.back().size) +
         " instances. From the first size with contacts, " +
         shown(points_in_contact(instances, crowd.column().key).front().size) +
         " instances, its time grows with the power " +
         shown(exponent_of(instances, crowd.column().key)) +
         " of the number of instances, and the contacts with " +
         shown(exponent_of(instances, "contacts")) +
         ". Methods that are queried pair by pair stop at " +
         shown(points_of(instances, kGrowingMethods[0].column().key).back().size) +
         ", because they query all pairs.";
}

/// The conclusions from the exponents of the first growth.
std::string text_of_exponents(const Growth& triangles) {
  const auto power = [&](const std::string& key) { return shown(exponent_of(triangles, key)); };
  return "Two surfaces intersect in curves, so the number of contacts grows with the power " +
         power("contacts") + " of the number of triangles. The time of Pelt grows with the power " +
         power("on_demand_us") + ", and that of the paper on demand with " + power("paper_us") +
         ". Of the methods that skin and refit everything first, Pelt eager has the power " +
         power("eager_us") + " and the paper bottom-up the power " + power("paper_eager_us") + '.';
}

/// From apart to the same position.
std::string text_of_depth(const Table& depth) {
  const auto times = [&](const std::vector<Cell>& row) {
    const auto time = [&](const char* key) { return shown(row[column_of(depth, key)]) + " us"; };
    return "Pelt takes " + time("on_demand_us") + " and Pelt eager " + time("eager_us");
  };
  return "Refitting on demand saves less, the deeper bodies intersect. Apart, " +
         times(depth.rows.front()) + "; at the same position, " + times(depth.rows.back()) + '.';
}

Chart chart_of(const Growth& growth) {
  Chart chart;
  chart.id = growth.table.id;
  chart.title = growth.table.title;
  chart.table = growth.table.id;
  chart.x = growth.chart_over.empty() ? growth.size : growth.chart_over;
  if (!growth.chart_over.empty()) chart.axes = Axes::logarithmic_y;
  chart.y_title = "time [us]";
  for (const GrowingMethod& method : kGrowingMethods)
    if (has_column(growth.table, method.column().key)) chart.y.push_back(method.column().key);
  return chart;
}

}  // namespace

Table exponents_of(std::span<const Growth> growths) {
  Table table = {
      "growth_exponents",
      "Times as powers of the growing number",
      {{"what", "what grows"},
       {"from", "from"},
       {"to", "to"},
       {"sizes", "sizes"},
       {"contacts", "contacts"}},
      {},
      "The exponent b of a x^b, by least squares of the logarithms over the sizes at which a "
      "method was measured and bodies are in contact; \"from\", \"to\" and \"sizes\" "
      "belong to the contacts. Times hardly grow with the number of joints, so these exponents "
      "mean little."};
  for (const GrowingMethod& method : kGrowingMethods)
    table.columns.push_back({method.key, method.name});
  for (const Growth& growth : growths) {
    const std::vector<Measured> points = points_in_contact(growth, "contacts");
    table.rows.push_back({growth.size, points.front().size, points.back().size,
                          static_cast<double>(points.size()), exponent_of(growth, "contacts")});
    for (const GrowingMethod& method : kGrowingMethods)
      table.rows.back().push_back(exponent_of(growth, method.column().key));
  }
  return table;
}

Result<Section> growth(const Conditions& conditions) {
  auto triangles = growth_by_triangles(chosen(kTriangles, 5, conditions), conditions);
  if (!triangles) return triangles.error();
  auto joints = growth_by_joints(kJoints, conditions);
  if (!joints) return joints.error();
  auto instances = growth_by_instances(chosen(kInstances, 6, conditions),
                                       conditions.is_quick ? 32 : 100, conditions);
  if (!instances) return instances.error();
  auto depth = growth_by_depth(scenes::kCreature.triangles, kDistances, conditions);
  if (!depth) return depth.error();
  const std::array growths = {Growth{"triangles", std::move(*triangles)},
                              Growth{"joints", std::move(*joints)},
                              Growth{"instances", std::move(*instances)},
                              Growth{"contacts", std::move(*depth), "distance"}};
  Section section;
  section.text = {text_of_exponents(growths[0])};
  for (const Growth& growth : growths) section.text.push_back(text_of(growth));
  section.text.push_back(text_of_crowd(growths[2]));
  section.text.push_back(text_of_depth(growths[3].table));
  section.tables = {exponents_of(growths)};
  for (const Growth& growth : growths) {
    section.tables.push_back(growth.table);
    section.charts.push_back(chart_of(growth));
  }
  return section;
}

}  // namespace pelt::reproduce

#include "tools/pelt/bench/anytime_chart.hpp"

#include "tools/pelt/bench/anytime_report.hpp"
#include "tools/pelt/bench/line_chart.hpp"
#include "tools/pelt/output/text.hpp"

#include <algorithm>
#include <cmath>

namespace pelt::tools::bench {
namespace {

/// Dark enough on white, and distinguishable for people with red-green colour blindness.
constexpr std::pair<const char*, const char*> kStyles[] = {
    {"#1c6b4a", ""}, {"#2f5fa8", "7 4"}, {"#c28a00", "2 3"}, {"#b5533c", "12 4 3 4"}};

/// Smaller shares of undecided pairs are at the lower end of the axis.
constexpr double kLeastUndecided = 1e-4;  // per cent

const auto& style_of(std::size_t method) { return kStyles[method % std::size(kStyles)]; }

/// A line for each method, of `value(known)`, until the method is complete.
template <typename Value>
std::vector<Line> lines_of(const AnytimeSceneFigures& scene, const Value& value) {
  std::vector<Line> lines;
  for (std::size_t m = 0; m < scene.methods.size(); ++m) {
    const auto& [colour, dashes] = style_of(m);
    lines.push_back({colour, dashes, {}});
    for (const AnytimeRung& rung : scene.methods[m].course) {
      lines.back().points.emplace_back(100 * rung.time, value(rung.known));
      if (rung.known.undecided == 0) break;
    }
  }
  return lines;
}

double highest_of(const std::vector<Line>& lines) {
  double highest = 0;
  for (const Line& line : lines)
    for (const auto& [at, value] : line.points) highest = std::max(highest, value);
  return highest > 0 ? highest : 1;
}

PanelRow row_of(const AnytimeSceneFigures& scene) {
  PanelRow row;
  row.title = scene.scene + ": " + output::counted(scene.pairs, "pair") +
              " of instances in contact, " + output::with_commas(scene.triangles) + " triangles";
  row.last = 100 * std::max(scene.methods[0].course.back().time, 1.0);
  row.panels.push_back({"contacts listed", Scale::linear, 0, 100, " %",
                        lines_of(scene, [](const auto& known) { return 100 * known.listed; })});
  row.panels.push_back({"pairs of triangles undecided", Scale::logarithmic, kLeastUndecided, 100,
                        " %",
                        lines_of(scene, [](const auto& known) { return 100 * known.undecided; })});
  std::vector<Line> longest = lines_of(scene, [](const auto& known) { return known.resolution; });
  const double highest = highest_of(longest);
  row.panels.push_back({"longest side of an open region, in model units", Scale::linear, 0, highest,
                        "", std::move(longest)});
  return row;
}

/// With the area of each scene.
std::vector<LegendEntry> legend_of(const std::vector<AnytimeSceneFigures>& scenes) {
  std::vector<LegendEntry> legend;
  for (std::size_t m = 0; m < scenes[0].methods.size(); ++m) {
    const auto& [colour, dashes] = style_of(m);
    legend.push_back({colour, dashes, scenes[0].methods[m].title + ": area"});
    for (const AnytimeSceneFigures& scene : scenes)
      legend.back().text.append(" ").append(output::fixed(scene.methods[m].area_over_work, 2));
  }
  return legend;
}

}  // namespace

std::string anytime_chart(const std::vector<AnytimeSceneFigures>& scenes) {
  LineChart chart;
  chart.title = "What is known when a query is stopped";
  chart.note =
      "Means over the pairs. Area: below contacts listed, over each method's own work, 1 if all "
      "are "
      "listed at once. Dotted: the time of a complete search in the order contacts.";
  chart.x_title = "time, in per cent of a complete search";
  chart.legend = legend_of(scenes);
  for (const AnytimeSceneFigures& scene : scenes) chart.rows.push_back(row_of(scene));
  return svg_of(chart);
}

}  // namespace pelt::tools::bench

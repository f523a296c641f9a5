/// The comparison over distance and resolution, and how the time of a deep contact splits.

#include "evaluation/reproduce/comparison_methods.hpp"
#include "evaluation/reproduce/comparison_tables.hpp"
#include "evaluation/reproduce/facing_pair.hpp"
#include "evaluation/reproduce/method_title.hpp"

#include <algorithm>
#include <cmath>

namespace pelt::reproduce {
namespace {

using methods::MethodKind;
using tools::bench::Question;
using tools::bench::SceneFigures;

/// From apart to two in the same position.
constexpr std::array kDistances = {3.0, kApart, 0.9, 0.8, kTouching, 0.6, 0.45, kDeep, 0.15, 0.0};

/// For larger meshes, building a tree in each frame takes seconds.
constexpr std::uint32_t kMaxRebuilt = 100000;

double height_of(const scenes::Character& character) {
  float low = HUGE_VALF, high = -HUGE_VALF;
  for (const Vec3& p : character.asset.mesh().rest_positions) {
    low = std::min(low, p.y);
    high = std::max(high, p.y);
  }
  return double{high} - low;
}

std::string mean_over_phases(const Conditions& conditions) {
  return conditions.is_quick ? "One phase of the walk."
                             : "Means over " + std::to_string(kPhases) + " phases of the walk.";
}

std::vector<MethodKind> methods_for(std::uint32_t triangles) {
  std::vector<MethodKind> methods(kCompared.begin(), kCompared.end());
  if (triangles > kMaxRebuilt)
    methods.erase(std::find(methods.begin(), methods.end(), lab::kAabbRebuild));
  return methods;
}

/// Splits the time before the query into skinning and the rest, if the two can be separated.
std::array<Cell, 2> update_split(MethodKind method, double update, double skinning) {
  switch (method.skins) {
    case methods::Skins::first:
      return {std::min(skinning, update), std::max(update - skinning, 0.0)};
    case methods::Skins::with_boxes:
      return {"in structure", update};
    case methods::Skins::where_queried:
      break;
  }
  return {"in query", update};
}

}  // namespace

Result<void> add_separation(const scenes::Character& creature, const Conditions& conditions,
                            Section& section) {
  const double height = height_of(creature);
  const std::string note = how_measured(
      mean_over_phases(conditions) + " The creatures are " + shown(height) + " units tall.",
      conditions);
  const Column distance = {"distance", "distance [units]"};
  const Column share = {"distance_heights", "distance [heights of a creature]"};
  Table all = times_table("separation", "All contacts of two creatures over their distance",
                          {distance, share, {"contacts", "contacts"}}, kCompared, note);
  Table first =
      times_table("separation_first", "First contact of two creatures over their distance",
                  {distance, share}, kCompared, note);
  for (const double at : kDistances) {
    const auto figures =
        measure_scene(facing_pair(creature, at, kPhases), kCompared, kPhases, conditions);
    if (!figures) return figures.error();
    all.rows.push_back({at, at / height, contact_count(*figures)});
    append_times(*figures, Question::all, kCompared, all.rows.back());
    first.rows.push_back({at, at / height});
    append_times(*figures, Question::first, kCompared, first.rows.back());
  }
  const double chart_end = (kApart + 0.001) / height;
  add_with_charts(std::move(all), "distance_heights", Axes::logarithmic_y, chart_end, section);
  add_with_charts(std::move(first), "distance_heights", Axes::logarithmic_y, chart_end, section);
  return {};
}

Result<void> add_resolution(const Conditions& conditions, Section& section) {
  Table table = times_table(
      "resolution", "Two creatures whose hands touch, over their numbers of triangles",
      {{"triangles", "triangles of one"}, {"contacts", "contacts"}}, kCompared,
      how_measured("One phase of the walk, " + shown(kTouching) + " units apart; all contacts. " +
                       title_of(lab::kAabbRebuild) + " is not measured beyond 100,000.",
                   conditions));
  std::vector<std::uint32_t> sizes = {1000, 3000, 10000, 30000, 100000, 300000, 1000000};
  if (conditions.is_quick) sizes.resize(3);
  for (const std::uint32_t triangles : sizes) {
    scenes::CreatureOptions options = scenes::kCreature;
    options.triangles = triangles;
    const auto creature = scenes::generate_character(options);
    if (!creature) return creature.error();
    const auto figures =
        measure_scene(facing_pair(*creature, kTouching), methods_for(triangles), 1, conditions);
    if (!figures) return figures.error();
    table.rows.push_back({static_cast<double>(triangles), contact_count(*figures)});
    append_times(*figures, Question::all, kCompared, table.rows.back());
  }
  add_with_charts(std::move(table), "triangles", Axes::logarithmic, {}, section);
  return {};
}

Result<Table> time_split(const scenes::Character& creature, const Conditions& conditions) {
  const auto figures =
      measure_scene(facing_pair(creature, kDeep, kPhases), kCompared, kPhases, conditions);
  if (!figures) return figures.error();
  Table table = {
      "time_split",
      "Two creatures deep in each other, " + shown(kDeep) + " units apart: how the time splits",
      {{"method", "method"},
       {"skinning_us", "skinning [us]"},
       {"update_us", "structure [us]"},
       {"query_us", "query [us]"},
       {"all_us", "all [us]"},
       {"triangle_pairs", "triangle pairs tested"}},
      {},
      how_measured(mean_over_phases(conditions), conditions) +
          " All contacts. Skinning is the time to skin all vertices at once, measured separately. "
          "If a method skins vertices while it computes boxes or runs the query, this time cannot "
          "be separated. Hashing builds its grid in the query, from the triangles of bodies whose "
          "boxes overlap."};
  for (const MethodKind method : kCompared) {
    const tools::bench::Figures& of = figures_of(*figures, method.name, Question::all);
    const double update = of.times.mean_update_us;
    auto [skinning, structure] = update_split(method, update, figures->skinning.mean_us);
    const double pairs =
        static_cast<double>(of.answer.work.triangle_pairs) / static_cast<double>(figures->frames);
    table.rows.push_back({title_of(method), skinning, structure, of.times.mean_us - update,
                          of.times.mean_us, pairs});
  }
  return table;
}

}  // namespace pelt::reproduce

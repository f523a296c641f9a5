/// The comparison over distance and resolution, and how the time of a deep contact splits.

#include "evaluation/reproduce/comparison.hpp"

#include "evaluation/bench/bench.hpp"
#include "evaluation/reproduce/scene_figures.hpp"
#include "evaluation/rivals/posed_mesh_method.hpp"
#include "scenes/creature/random.hpp"
#include "text/format.hpp"

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

namespace {

// The comparison over the number of instances: pair by pair and, if a method supports it, all
// pairs at once.

constexpr std::array kByPairs = {methods::kOnDemand, methods::kEager,  methods::kPaper,
                                 lab::kPaperEager,   lab::kHybrid,     lab::kAabbRefit,
                                 lab::kHash,         lab::kHashOverlap};

/// Names of the methods that query all pairs at once.
constexpr const char *kCrowd = "crowd", *kOneGrid = "hash_crowd";

constexpr double kTurn = 6.283185307179586;

/// Distances of neighbours in a row, and of rows, in units of a creature 1.8 tall.
constexpr double kNearest = 0.5, kFarthest = 1.4, kRow = 1.5;

/// Creatures that walk on the spot in rows, in different directions.
scenes::Scene walkers(const scenes::Character& creature, std::uint32_t count) {
  scenes::Scene scene;
  scene.name = std::to_string(count) + " walkers";
  scene.characters = {creature};
  scene.frame_count = kPhases;
  scene.fps = 4;
  scenes::SplitMix64 random(1);
  const auto side = static_cast<std::uint32_t>(std::ceil(std::sqrt(count)));
  double x = 0;
  for (std::uint32_t i = 0; i < count; ++i) {
    x = i % side == 0 ? 0 : x + random.between(kNearest, kFarthest);
    scenes::Instance walker;
    walker.clip = "walk";
    walker.start = random.between(0, 1);
    walker.translation = {x, 0, kRow * (i / side)};
    const double half = random.between(0, kTurn / 2);
    walker.rotation = {0, std::sin(half), 0, std::cos(half)};
    scene.instances.push_back(walker);
  }
  return scene;
}

std::vector<tools::bench::BenchMethod> compared_methods() {
  std::vector<tools::bench::BenchMethod> all = {tools::bench::crowd_method(1)};
  all[0].name = kCrowd;
  for (const MethodKind method : kByPairs) all.push_back(tools::bench::method_of(method));
  all.push_back(lab::rival_method(kOneGrid, [] { return rivals::make_hash_crowd(); }));
  return all;
}

Table empty_table(const scenes::Character& creature, const Conditions& conditions) {
  Table table = {
      "instances",
      "All contacts of a crowd of walkers, over their number",
      {{"instances", "instances"}, {"contacts", "contacts"}},
      {},
      how_measured("Creatures of " + text::with_commas(creature.asset.triangles.size()) +
                       " triangles on a plain, 0.5 to 1.4 units from "
                       "their neighbours. Pairs are queried one by one, except by Pelt's "
                       "crowd and the hash in one grid, which query all at once. Wall time.",
                   conditions)};
  table.columns.push_back({"crowd_us", title_of(methods::kOnDemand) + " as a crowd [us]"});
  for (const MethodKind method : kByPairs) table.columns.push_back(time_column(method));
  table.columns.push_back({"hash_crowd_us", title_of(lab::kHash) + " in one grid [us]"});
  return table;
}

}  // namespace

Result<void> add_instances(const scenes::Character& creature, const Conditions& conditions,
                           Section& section) {
  Table table = empty_table(creature, conditions);
  std::vector<std::uint32_t> counts = {2, 8, 32, 100};
  if (conditions.is_quick) counts.pop_back();
  for (const std::uint32_t count : counts) {
    const auto figures =
        measure_scene(walkers(creature, count), compared_methods(), kPhases, conditions);
    if (!figures) return figures.error();
    const auto time = [&](std::string_view method) {
      return figures_of(*figures, method, Question::all).times.mean_us;
    };
    std::vector<Cell> row = {static_cast<double>(count), contact_count(*figures), time(kCrowd)};
    for (const MethodKind method : kByPairs) row.push_back(time(method.name));
    row.push_back(time(kOneGrid));
    table.rows.push_back(std::move(row));
  }
  Chart chart = {table.id, table.title, table.id, "instances", {}, "per frame [us]"};
  for (std::size_t c = 2; c < table.columns.size(); ++c) chart.y.push_back(table.columns[c].key);
  section.charts.push_back(std::move(chart));
  section.tables.push_back(std::move(table));
  return {};
}

namespace {

// The parameters that users of the rivals have to choose.

/// A method for each value of a parameter.
struct Tuned {
  MethodKind method;
  std::function<std::unique_ptr<rivals::PosedMeshMethod>(double value)> make;
};

struct Case {
  const char *key, *title;
  double distance;
  Question question;
};

constexpr std::array kCases = {Case{"light", "light, all", kTouching, Question::all},
                               Case{"light_first", "light, first", kTouching, Question::first},
                               Case{"deep", "deep, all", kDeep, Question::all},
                               Case{"deep_first", "deep, first", kDeep, Question::first}};

std::string method_name(MethodKind method, double value) {
  return std::string(method.name) + " " + shown(value);
}

/// Measures all values in turn, so that changes in the load of the machine affect all alike.
Result<tools::bench::SceneFigures> measure_values(const scenes::Character& creature,
                                                  double distance, std::span<const Tuned> tuned,
                                                  std::span<const double> values,
                                                  const Conditions& conditions) {
  std::vector<tools::bench::BenchMethod> methods;
  for (const double value : values)
    for (const Tuned& one : tuned)
      methods.push_back(lab::rival_method(method_name(one.method, value),
                                          [&one, value] { return one.make(value); }));
  return measure_scene(facing_pair(creature, distance, kPhases), std::move(methods), kPhases,
                       conditions);
}

/// Adds a row for each value, with a time for each method and case.
Result<void> fill(const scenes::Character& creature, std::span<const Tuned> tuned,
                  std::span<const double> values, const Conditions& conditions, Table& table) {
  const auto light = measure_values(creature, kTouching, tuned, values, conditions);
  if (!light) return light.error();
  const auto deep = measure_values(creature, kDeep, tuned, values, conditions);
  if (!deep) return deep.error();
  for (const Tuned& one : tuned)
    for (const Case& of : kCases)
      table.columns.push_back({std::string(one.method.name) + "_" + of.key + "_us",
                               title_of(one.method) + ", " + of.title + " [us]"});
  for (const double value : values) {
    table.rows.push_back({value});
    for (const Tuned& one : tuned)
      for (const Case& of : kCases) {
        const auto& figures = of.distance == kDeep ? *deep : *light;
        table.rows.back().push_back(
            figures_of(figures, method_name(one.method, value), of.question).times.mean_us);
      }
  }
  return {};
}

std::string note_of(const std::string& usual, const Conditions& conditions) {
  return "Elsewhere " + usual + ". Light: two creatures " + shown(kTouching) +
         " units apart; deep: " + shown(kDeep) + ". " + how_measured("", conditions);
}

}  // namespace

Result<Table> cell_sizes(const scenes::Character& creature, const Conditions& conditions) {
  Table table = {
      "cell_size",
      "Hashing over the edge of its cells",
      {{"cell_edges", "cell [mean edges]"}},
      {},
      note_of(shown(double{rivals::HashOptions{}.cell_edges}) + " is taken", conditions)};
  const auto options = [](double v) { return rivals::HashOptions{static_cast<float>(v)}; };
  const std::array tuned = {
      Tuned{lab::kHash, [=](double v) { return rivals::make_hash(options(v)); }},
      Tuned{lab::kHashOverlap, [=](double v) { return rivals::make_hash_overlap(options(v)); }}};
  constexpr std::array kEdges = {1.0, 1.5, 2.0, 3.0, 4.0, 6.0, 10.0};
  const auto done = fill(creature, tuned, kEdges, conditions, table);
  if (!done) return done.error();
  return table;
}

Result<Table> leaf_sizes(const scenes::Character& creature, const Conditions& conditions) {
  Table table = {"leaf_size",
                 "Trees of boxes over the size of their leaves",
                 {{"leaf_triangles", "triangles in a leaf, at most"}},
                 {},
                 note_of(shown(rivals::TreeOptions{}.leaf_triangles) + " are taken", conditions)};
  const auto options = [](double v) { return rivals::TreeOptions{static_cast<std::uint32_t>(v)}; };
  const std::array tuned = {
      Tuned{lab::kAabbRefit, [=](double v) { return rivals::make_aabb_refit(options(v)); }},
      Tuned{lab::kHybrid, [=](double v) { return rivals::make_hybrid(options(v)); }}};
  constexpr std::array kLeaves = {1.0, 2.0, 4.0, 8.0, 16.0, 32.0};
  const auto done = fill(creature, tuned, kLeaves, conditions, table);
  if (!done) return done.error();
  return table;
}

}  // namespace pelt::reproduce

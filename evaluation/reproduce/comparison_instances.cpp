/// The comparison over the number of instances: pair by pair and, if a method supports it, all
/// pairs at once.

#include "evaluation/reproduce/comparison_methods.hpp"
#include "evaluation/reproduce/comparison_tables.hpp"
#include "evaluation/reproduce/method_title.hpp"
#include "evaluation/rivals/hash_crowd.hpp"
#include "scenes/creature/random.hpp"
#include "text/format.hpp"

#include <cmath>

namespace pelt::reproduce {
namespace {

using methods::MethodKind;
using tools::bench::Question;

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
  all.push_back(rival_method(kOneGrid, [] { return rivals::make_hash_crowd(); }));
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

}  // namespace pelt::reproduce

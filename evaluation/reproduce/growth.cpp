#include "evaluation/reproduce/growth.hpp"

#include "base/assert.hpp"
#include "evaluation/programs/crowd.hpp"
#include "evaluation/reproduce/scene_figures.hpp"
#include "scenes/creature.hpp"
#include "text/format.hpp"
#include "tools/pelt/bench/stopwatch.hpp"
#include "tools/pelt/output/statistics.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

namespace pelt::reproduce {

double fitted_exponent(std::span<const Measured> points) {
  std::vector<Measured> logs;
  Measured mean;
  for (const Measured& point : points) {
    if (point.size <= 0 || point.value <= 0) continue;
    logs.push_back({std::log(point.size), std::log(point.value)});
    mean.size += logs.back().size;
    mean.value += logs.back().value;
  }
  mean.size /= static_cast<double>(logs.size());
  mean.value /= static_cast<double>(logs.size());
  double product = 0, square = 0;
  for (const Measured& log : logs) {
    product += (log.size - mean.size) * (log.value - mean.value);
    square += (log.size - mean.size) * (log.size - mean.size);
  }
  PELT_ASSERT(square > 0);
  return product / square;
}

namespace {

/// Time per frame: the median over the frames. Contacts: of the last frame.
struct PairwiseTiming {
  double frame_us = 0;
  std::size_t contacts = 0;
};

/// Sets the palettes of all bodies, which are one after the other in `palettes`.
void set_palettes(const programs::CrowdJob& job, std::span<const Matrix4> palettes,
                  methods::Method& method) {
  for (std::uint32_t body = 0; body < job.models.size(); ++body) {
    const std::uint32_t joints = job.models[body].joint_count();
    const Result<void> taken = method.set_palette(body, palettes.first(joints));
    PELT_ASSERT(taken);
    palettes = palettes.subspan(joints);
  }
}

/// Runs a method on the frames of a crowd, pair by pair. As in CrowdRun, a frame consists of
/// setting all palettes and finding all contacts.
PairwiseTiming run_by_pairs(const programs::CrowdJob& job, methods::MethodKind kind) {
  const std::unique_ptr<methods::Method> method = kind.make();
  for (const SkinnedModel& model : job.models) method->add(model);
  std::vector<Matrix4> palettes;
  std::vector<Contact> contacts;
  std::vector<double> times;
  for (std::uint32_t frame = 0; frame < job.frame_count; ++frame) {
    job.pose(frame, palettes);
    contacts.clear();
    tools::bench::Stopwatch watch;
    set_palettes(job, palettes, *method);
    for (std::uint32_t a = 0; a < job.models.size(); ++a)
      for (std::uint32_t b = a + 1; b < job.models.size(); ++b) method->collide(a, b, contacts, {});
    watch.stop();
    times.push_back(watch.microseconds());
  }
  return {tools::output::median(times), contacts.size()};
}

// Two creatures that face each other, queried for all contacts.

/// A distance at which arms reach into the other creature.
constexpr double kInterfering = 0.6;

Table empty_table(const char* id, const char* title, const Column& size, const std::string& note) {
  Table table = {id, title, {size, {"contacts", "contacts"}}, {}, note};
  for (std::size_t i = 0; i < kPairMethods.size(); ++i)
    table.columns.push_back(kGrowingMethods[i].column());
  return table;
}

/// Appends contacts and times of one pair.
Result<void> append_row(double size, const scenes::Character& character, double distance,
                        const Conditions& conditions, Table& table) {
  const auto figures = measure_scene(facing_pair(character, distance), kPairMethods, 1, conditions);
  if (!figures) return figures.error();
  std::vector<Cell> row = {size, contact_count(*figures)};
  for (const methods::MethodKind method : kPairMethods)
    row.push_back(mean_us(*figures, method, tools::bench::Question::all));
  table.rows.push_back(std::move(row));
  return {};
}

/// The same for two creatures that intersect. Returns the number of triangles of each.
Result<std::size_t> append_generated(double size, const scenes::CreatureOptions& options,
                                     const Conditions& conditions, Table& table) {
  const Result<scenes::Character> character = scenes::generate_character(options);
  if (!character) return character.error();
  const auto done = append_row(size, *character, kInterfering, conditions, table);
  if (!done) return done.error();
  return character->asset.triangles.size();
}

/// "Two creatures of 56 joints, 0.6 units apart; all contacts."
std::string interfering_pair(std::size_t count, const char* things) {
  return "Two creatures of " + text::with_commas(count) + " " + things + ", " +
         text::fixed(kInterfering, 1) + " units apart; all contacts.";
}

}  // namespace

Result<Table> growth_by_triangles(std::span<const std::uint32_t> triangles,
                                  const Conditions& conditions) {
  Table table = empty_table("growth_triangles", "Time of a query, by number of triangles",
                            {"triangles", "triangles of each"},
                            interfering_pair(scenes::kCreature.joints, "joints"));
  for (const std::uint32_t count : triangles) {
    scenes::CreatureOptions options = scenes::kCreature;
    options.triangles = count;
    const auto done = append_generated(count, options, conditions, table);
    if (!done) return done.error();
  }
  return table;
}

Result<Table> growth_by_joints(std::span<const std::uint32_t> joints,
                               const Conditions& conditions) {
  Table table = empty_table("growth_joints", "Time of a query, by number of joints",
                            {"joints", "joints of each"}, "");
  for (const std::uint32_t count : joints) {
    scenes::CreatureOptions options = scenes::kCreature;
    options.joints = count;
    const auto triangles = append_generated(count, options, conditions, table);
    if (!triangles) return triangles.error();
    table.note = interfering_pair(*triangles, "triangles");
  }
  return table;
}

Result<Table> growth_by_depth(std::uint32_t triangles, std::span<const double> distances,
                              const Conditions& conditions) {
  scenes::CreatureOptions options = scenes::kCreature;
  options.triangles = triangles;
  const auto character = scenes::generate_character(options);
  if (!character) return character.error();
  Table table =
      empty_table("growth_depth", "Time of a query, by depth", {"distance", "distance [units]"},
                  "Two creatures 1.8 units tall that face each other, from apart to the "
                  "same position; all contacts.");
  for (const double distance : distances) {
    const auto done = append_row(distance, *character, distance, conditions, table);
    if (!done) return done.error();
  }
  return table;
}

namespace {

// Walking crowds, queried as a whole by one thread, and pair by pair.

/// Units of the creature per metre of the crowd; dense enough that small crowds have contacts too.
constexpr double kMetre = 1.2;

/// A creature, and crowds of it.
struct Walkers {
  explicit Walkers(const asset::Asset& asset, const SkinnedModel& m) : model(m), phases(asset) {}

  SkinnedModel model;
  programs::WalkPhases phases;
};

Result<Walkers> make_walkers() {
  const Result<asset::Asset> asset = scenes::make_creature();
  if (!asset) return asset.error();
  const std::vector<Matrix4> samples = programs::WalkPhases(*asset).samples();
  const Result<SkinnedModel> model = build_model(asset->mesh(), {.sample_palettes = samples});
  if (!model) return model.error();
  return Walkers(*asset, *model);
}

/// Adds the times of all methods that are queried pair by pair to those of the crowd.
Result<void> append_pairwise(const programs::CrowdJob& job, const programs::CrowdTiming& crowd,
                             std::vector<Cell>& row) {
  for (const methods::MethodKind method : kPairMethods) {
    const PairwiseTiming timing = run_by_pairs(job, method);
    if (timing.contacts != crowd.contacts)
      return Error{ErrorCode::invalid_argument,
                   std::string(method.name) + " finds " + std::to_string(timing.contacts) +
                       " contacts between " + std::to_string(job.models.size()) +
                       " walkers, but the crowd query finds " + std::to_string(crowd.contacts) +
                       ": please report this"};
    row.push_back(timing.frame_us);
  }
  return {};
}

Result<std::vector<Cell>> crowd_row(const Walkers& walkers, std::uint32_t count, bool by_pairs,
                                    const Conditions& conditions) {
  const programs::WalkingCrowd crowd(walkers.phases, count, kMetre);
  programs::CrowdJob job;
  job.models.assign(count, walkers.model);
  job.frame_count = conditions.is_quick ? 3 : 9;
  job.pose = [&](std::uint32_t frame, std::vector<Matrix4>& palettes) {
    crowd.pose(frame, palettes);
  };
  const programs::CrowdTiming timing =
      programs::CrowdRun(job).best_of(conditions.is_quick ? 1 : 3, 1);
  std::vector<Cell> row = {static_cast<double>(count), static_cast<double>(timing.contacts),
                           static_cast<double>(timing.stats.intersecting_pairs)};
  if (by_pairs) {
    if (const auto done = append_pairwise(job, timing, row); !done) return done.error();
  } else {
    row.resize(row.size() + kPairMethods.size());
  }
  row.push_back(1000 * timing.frame_ms);
  return row;
}

}  // namespace

Result<Table> growth_by_instances(std::span<const std::uint32_t> instances,
                                  std::uint32_t most_by_pairs, const Conditions& conditions) {
  const Result<Walkers> walkers = make_walkers();
  if (!walkers) return walkers.error();
  Table table = {
      "growth_instances",
      "Time per frame, by number of instances",
      {{"instances", "instances"},
       {"contacts", "contacts"},
       {"touching_pairs", "pairs in contact"}},
      {},
      "Creatures of " + text::with_commas(walkers->model.triangle_count()) +
          " triangles that walk on a plain, 0.5 to 1.4 units from their neighbours. The time is "
          "that of setting palettes and finding all contacts on one thread. Contacts are those of "
          "the last timed frame."};
  for (const GrowingMethod& method : kGrowingMethods) table.columns.push_back(method.column());
  for (const std::uint32_t count : instances) {
    auto row = crowd_row(*walkers, count, count <= most_by_pairs, conditions);
    if (!row) return row.error();
    table.rows.push_back(std::move(*row));
  }
  return table;
}

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

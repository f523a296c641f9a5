/// The parameters that users of the rivals have to choose.

#include "evaluation/reproduce/comparison_methods.hpp"
#include "evaluation/reproduce/comparison_tables.hpp"
#include "evaluation/reproduce/facing_pair.hpp"
#include "evaluation/reproduce/method_title.hpp"
#include "evaluation/rivals/posed_mesh_method.hpp"

namespace pelt::reproduce {
namespace {

using methods::MethodKind;
using tools::bench::Question;

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
      methods.push_back(
          rival_method(method_name(one.method, value), [&one, value] { return one.make(value); }));
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

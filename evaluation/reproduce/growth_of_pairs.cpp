/// Two creatures that face each other, queried for all contacts.

#include "evaluation/reproduce/facing_pair.hpp"
#include "evaluation/reproduce/growth.hpp"
#include "evaluation/reproduce/scene_figures.hpp"
#include "text/format.hpp"

namespace pelt::reproduce {
namespace {

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

}  // namespace pelt::reproduce

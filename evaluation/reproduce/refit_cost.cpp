/// The cost of one refit of the paper's method (the flops of section 4.2, the times of section 5),
/// and the work that it saves: refitting everything, and building trees again.

#include "base/assert.hpp"
#include "evaluation/reproduce/refit_all.hpp"
#include "evaluation/reproduce/refit_flops.hpp"
#include "evaluation/reproduce/refit_time.hpp"
#include "evaluation/reproduce/specimen.hpp"
#include "paper/on_demand.hpp"
#include "text/format.hpp"

#include <algorithm>

namespace pelt::reproduce {
namespace {

using detail::Palette;
using paper::SphereModel;

/// At this time of the walk, both legs and both arms are apart.
constexpr float kSeconds = 0.3f;

std::uint32_t repetitions_of(const Conditions& conditions) {
  return conditions.is_quick ? 50 : 500;
}

/// Refits of the creature's spheres, classified by joints or by corners.
Table class_table(const char* id, const char* title, const std::vector<NodeClass>& classes) {
  Table table = {id,
                 title,
                 {{"joints", "joints"},
                  {"corners", "corners"},
                  {"spheres", "spheres"},
                  {"flops", "flops, by the formula"},
                  {"refit_ns", "a refit [ns]"},
                  {"flops_per_ns", "flops / ns"}},
                 {},
                 "Joints and corners are summed over the joint sets of a sphere. Means of classes "
                 "of spheres, of at most 256 spheres each, which stay in the caches."};
  for (const NodeClass& c : classes)
    table.rows.push_back({c.facts.joints, c.facts.corners, c.nodes, c.facts.flops, c.nanoseconds,
                          c.facts.flops / c.nanoseconds});
  return table;
}

std::vector<Table> class_tables(const Specimen& creature, const Conditions& conditions) {
  const SphereModel model = paper::build_sphere_model(creature.mesh);
  const Palette palette = walking_palette(creature, kSeconds);
  const std::vector<NodeFacts> facts = facts_of(model, creature.mesh);
  const auto classes = [&](double NodeFacts::*fact) {
    return time_classes(model, palette, facts, fact, repetitions_of(conditions));
  };
  return {
      class_table("refit_joints", "Time of a refit of the creature's spheres, by number of joints",
                  classes(&NodeFacts::joints)),
      class_table("refit_corners", "The same by corners", classes(&NodeFacts::corners))};
}

std::vector<NodeClass> classes_by_vertices(const detail::SkinnedMesh& mesh, const Palette& palette,
                                           const Conditions& conditions) {
  const SphereModel model = paper::build_sphere_model(mesh);
  return time_classes(model, palette, facts_of(model, mesh), &NodeFacts::vertices,
                      repetitions_of(conditions));
}

/// "The time complexity does not depend on the geometry that S encloses."
Result<Table> vertices_table(const Conditions& conditions) {
  Table table = {"refit_vertices",
                 "Time of a refit, by number of vertices below the node",
                 {{"vertices", "vertices below the node"},
                  {"spheres", "spheres"},
                  {"same_joints_ns", "all follow the same two joints [ns]"},
                  {"joints", "creature: joints"},
                  {"corners", "corners"},
                  {"creature_ns", "creature [ns]"}},
                 {},
                 ""};
  const std::uint32_t triangles = conditions.is_quick ? scenes::kCreature.triangles : 100000;
  scenes::CreatureOptions options = scenes::kCreature;
  options.triangles = triangles;
  const Result<Specimen> creature = make_specimen(options);
  if (!creature) return creature.error();
  table.note = "A creature of " + text::with_commas(creature->model.triangle_count()) +
               " triangles, and the same with other weights: all its vertices follow the same two "
               "joints. Both have the same tree.";
  const Palette palette = walking_palette(*creature, kSeconds);
  const auto own = classes_by_vertices(creature->mesh, palette, conditions);
  const auto same = classes_by_vertices(with_one_joint_set(creature->mesh), palette, conditions);
  PELT_ASSERT(own.size() == same.size());
  for (std::size_t i = 0; i < own.size(); ++i)
    table.rows.push_back({own[i].facts.vertices, own[i].nodes, same[i].nanoseconds,
                          own[i].facts.joints, own[i].facts.corners, own[i].nanoseconds});
  return table;
}

double figure(const Table& table, std::size_t row, const char* key) {
  return *table.rows[row][column_of(table, key)].figure;
}

/// "27.7 to 38.2", over all rows.
std::string range(const Table& table, const char* key) {
  double least = figure(table, 0, key), most = least;
  for (std::size_t row = 1; row < table.rows.size(); ++row) {
    least = std::min(least, figure(table, row, key));
    most = std::max(most, figure(table, row, key));
  }
  return shown(least) + " to " + shown(most);
}

std::string text_of_classes(const Table& joints, const Table& vertices) {
  const std::size_t last = joints.rows.size() - 1;
  return "One refit of the paper's method takes " + shown(figure(joints, 0, "refit_ns")) +
         " ns if the vertices have " + shown(figure(joints, 0, "joints")) + " joint and " +
         shown(figure(joints, last, "refit_ns")) + " ns with " +
         shown(figure(joints, last, "joints")) +
         " joints in all joint sets. The geometry does not matter: if all vertices follow the "
         "same two joints, a refit takes " +
         range(vertices, "same_joints_ns") + " ns for " + range(vertices, "vertices") +
         " vertices. Large spheres of the creature take longer because their vertices have more "
         "joints.";
}

std::string text_of_all(const Table& all) {
  return "All spheres of two men take " + shown(figure(all, 0, "on_demand_ms")) +
         " ms on demand and " + shown(figure(all, 0, "bottom_up_ms")) +
         " ms bottom-up, in the paper " + shown(figure(all, 1, "on_demand_ms")) + " and " +
         shown(figure(all, 1, "bottom_up_ms")) +
         " ms. Since then, one sphere on demand has become faster by a factor of " +
         shown(figure(all, 2, "on_demand_ns")) + ", and all spheres bottom-up by a factor of " +
         shown(figure(all, 2, "bottom_up_ms")) +
         ", presumably because bottom-up refitting accesses memory in order and needs no weights.";
}

std::string text_of_rebuild(const Table& rebuild) {
  const std::size_t creature = rebuild.rows.size() - 1;
  return "Building a tree of the creature costs " +
         shown(figure(rebuild, creature, "paper_over_bottom_up")) +
         " times as much as its spheres refitted bottom-up (about " +
         shown(figure(rebuild, creature, "printed_over_bottom_up")) +
         " for trees of boxes, the paper cites) and " +
         shown(figure(rebuild, creature, "paper_over_on_demand")) +
         " times as much as all of them refitted on demand. Pelt's model costs " +
         shown(figure(rebuild, creature, "ratio")) + " times as much as all its boxes.";
}

std::vector<Chart> charts() {
  return {{"refit_joints",
           "A refit by joints",
           "refit_joints",
           "joints",
           {"refit_ns"},
           "a refit [ns]",
           Axes::logarithmic,
           Better::lower},
          {"refit_corners",
           "A refit by corners",
           "refit_corners",
           "corners",
           {"refit_ns"},
           "a refit [ns]",
           Axes::logarithmic,
           Better::lower},
          {"refit_vertices",
           "A refit by vertices below",
           "refit_vertices",
           "vertices",
           {"same_joints_ns", "creature_ns"},
           "a refit [ns]",
           Axes::logarithmic,
           Better::lower}};
}

}  // namespace

Result<Section> refit_cost(const Conditions& conditions) {
  const Result<Specimen> creature = make_specimen(scenes::kCreature);
  if (!creature) return creature.error();
  const std::vector<Table> classes = class_tables(*creature, conditions);
  const auto flops = flops_table();
  if (!flops) return flops.error();
  const auto vertices = vertices_table(conditions);
  if (!vertices) return vertices.error();
  const auto all = all_spheres_table(conditions);
  if (!all) return all.error();
  const auto rebuild = rebuild_table(conditions);
  if (!rebuild) return rebuild.error();
  Section section;
  section.text = {text_of_classes(classes[0], *vertices), text_of_all(*all),
                  text_of_rebuild(*rebuild)};
  section.tables = {*flops, classes[0], classes[1], *vertices, *all, *rebuild};
  section.charts = charts();
  return section;
}

}  // namespace pelt::reproduce

/// What a refit of the paper's costs (section 4.2's count of flops, section 5's times), and what it
/// spares: refitting everything, and building trees anew.

#include "paper/on_demand.hpp"
#include "tools/pelt/text.hpp"
#include "tools/reproduce/eager_split.hpp"
#include "tools/reproduce/refit_all.hpp"
#include "tools/reproduce/refit_flops.hpp"
#include "tools/reproduce/refit_time.hpp"
#include "tools/reproduce/specimen.hpp"

namespace pelt::reproduce {
namespace {

using detail::Palette;
using paper::SphereModel;

/// Into the walk, both legs and arms apart.
constexpr float kSeconds = 0.3f;

std::uint32_t repetitions_of(const Conditions& conditions) {
  return conditions.is_quick ? 50 : 500;
}

/// Refits of the creature's spheres by their joints, or by their corners.
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
  return {class_table("refit_joints", "A refit of the creature's spheres, by joints",
                      classes(&NodeFacts::joints)),
          class_table("refit_corners", "The same by corners", classes(&NodeFacts::corners))};
}

/// "The time complexity does not depend on the geometry that S encloses."
Result<Table> vertices_table(const Conditions& conditions) {
  Table table = {"refit_vertices",
                 "A refit by the vertices below the node",
                 {{"vertices", "vertices below the node"},
                  {"spheres", "spheres"},
                  {"joints", "joints"},
                  {"corners", "corners"},
                  {"same_joints_ns", "same two joints [ns]"},
                  {"creature_ns", "creature [ns]"}},
                 {},
                 ""};
  const std::uint32_t triangles = conditions.is_quick ? 13590 : 100000;
  const Result<Specimen> creature = make_specimen(scenes::CreatureOptions{triangles, 56, 1});
  if (!creature) return creature.error();
  table.note = "A creature of " + tools::with_commas(triangles) +
               " triangles, and the same with other weights: all its vertices follow the same two "
               "joints.";
  const Palette palette = walking_palette(*creature, kSeconds);
  const auto append = [&](const detail::SkinnedMesh& mesh, bool is_creature) {
    const SphereModel model = paper::build_sphere_model(mesh);
    for (const NodeClass& c : time_classes(model, palette, facts_of(model, mesh),
                                           &NodeFacts::vertices, repetitions_of(conditions)))
      table.rows.push_back({c.facts.vertices, c.nodes, c.facts.joints, c.facts.corners,
                            is_creature ? Cell() : c.nanoseconds,
                            is_creature ? c.nanoseconds : Cell()});
  };
  append(with_one_joint_set(creature->mesh), false);
  append(creature->mesh, true);
  return table;
}

double figure(const Table& table, std::size_t row, const char* key) {
  return *table.rows[row][column_of(table, key)].figure;
}

std::string text_of_classes(const Table& joints, const Table& vertices) {
  const std::size_t last = joints.rows.size() - 1;
  std::size_t top = 0;  // the last class of the body whose vertices have the same joints
  while (top + 1 < vertices.rows.size() &&
         vertices.rows[top + 1][column_of(vertices, "same_joints_ns")].figure)
    ++top;
  return "A refit takes " + shown(figure(joints, 0, "refit_ns")) + " ns where the vertices have " +
         shown(figure(joints, 0, "joints")) + " joint and " +
         shown(figure(joints, last, "refit_ns")) + " ns with " +
         shown(figure(joints, last, "joints")) +
         " joints in all joint sets. The geometry does not count: where all vertices follow the "
         "same two joints, it takes " +
         shown(figure(vertices, 0, "same_joints_ns")) + " ns over " +
         shown(figure(vertices, 0, "vertices")) + " vertices and " +
         shown(figure(vertices, top, "same_joints_ns")) + " ns over " +
         shown(figure(vertices, top, "vertices")) +
         ". That large spheres of the creature take longer is because their vertices have more "
         "joints.";
}

std::string text_of_all(const Table& all, const Table& rebuild) {
  const std::size_t creature = rebuild.rows.size() - 1;
  return "All spheres of two men take " + shown(figure(all, 0, "on_demand_ms")) +
         " ms on demand and " + shown(figure(all, 0, "bottom_up_ms")) +
         " ms bottom-up, the paper's " + shown(figure(all, 1, "on_demand_ms")) + " and " +
         shown(figure(all, 1, "bottom_up_ms")) + " ms. A tree of the creature built anew costs " +
         shown(figure(rebuild, creature, "paper_ratio")) +
         " times as much as all its spheres refitted, and Pelt's model " +
         shown(figure(rebuild, creature, "ratio")) + " times as much as all its boxes.";
}

std::string text_of_split(const Table& split) {
  const auto of_men = [&](std::size_t row, const char* key) {
    return shown(figure(split, row, key)) + " us";
  };
  return "Of a frame of the two men, the paper's rival spends " + of_men(0, "skinning_us") +
         " on skinning, " + of_men(0, "refit_us") + " on refitting and " + of_men(0, "query_us") +
         " on the query; our eager method " + of_men(1, "skinning_us") + ", " +
         of_men(1, "refit_us") + " and " + of_men(1, "query_us") +
         ". The first two are what refit on demand saves where bodies are far from each other.";
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
  const auto split = eager_split_table(20, conditions);
  if (!split) return split.error();
  Section section;
  section.text = {text_of_classes(classes[0], *vertices), text_of_all(*all, *rebuild),
                  text_of_split(*split)};
  section.tables = {*flops, classes[0], classes[1], *vertices, *all, *rebuild, *split};
  section.charts = charts();
  return section;
}

}  // namespace pelt::reproduce

/// The cost of one refit of the paper's method (the flops of section 4.2, the times of section 5),
/// and the work that it saves: refitting everything, and building trees again.

#include "evaluation/reproduce/refit_cost.hpp"

#include "base/assert.hpp"
#include "evaluation/reproduce/characters.hpp"
#include "evaluation/reproduce/paper_figures.hpp"
#include "paper/counted_refit.hpp"
#include "paper/on_demand.hpp"
#include "scenes/creature/random.hpp"
#include "text/format.hpp"
#include "tools/pelt/bench/stopwatch.hpp"
#include "tools/pelt/output/statistics.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace pelt::reproduce {
namespace {

using detail::Palette;
using paper::SphereModel;

/// Limits of the nodes of a class. At least kFewest, because the clock is read once for all of
/// them. Times at most kMax, so that they stay in the caches.
constexpr std::size_t kFewest = 8, kMax = 256;

/// Counts the vertices of nodes, each once.
class VertexCounter {
 public:
  explicit VertexCounter(const detail::SkinnedMesh& mesh)
      : mesh_(mesh), last_node_(mesh.vertex_count(), UINT32_MAX) {}

  double count(std::uint32_t node, std::span<const std::uint32_t> triangles) {
    std::uint32_t count = 0;
    for (const std::uint32_t triangle : triangles)
      for (const std::uint32_t vertex : mesh_.triangles[triangle])
        count += std::exchange(last_node_[vertex], node) != node;
    return count;
  }

 private:
  const detail::SkinnedMesh& mesh_;
  std::vector<std::uint32_t> last_node_;  // by vertex: the last node that counted it
};

/// Half octaves: 1, 2, 3, 4 to 5, 6 to 7, 8 to 11, ...
double class_of(double fact) {
  const double octave = std::floor(std::log2(fact)), whole = std::exp2(octave);
  return 2 * octave + (fact >= 1.5 * whole ? 1 : 0);
}

std::vector<std::uint32_t> evenly_chosen(const std::vector<std::uint32_t>& nodes) {
  if (nodes.size() <= kMax) return nodes;
  std::vector<std::uint32_t> chosen;
  for (std::size_t i = 0; i < kMax; ++i) chosen.push_back(nodes[i * nodes.size() / kMax]);
  return chosen;
}

/// Nodes that are refitted one after the other, without the root.
struct Sample {
  std::vector<std::uint32_t> nodes;
  std::vector<double> microseconds;
};

/// Refits all samples in turn, so that changes in the load of the machine affect all alike.
void time_in_turn(const SphereModel& model, const Palette& palette, std::uint32_t repetitions,
                  std::vector<Sample>& samples) {
  paper::Refit refit(model, static_cast<std::uint32_t>(palette.joints().size()));
  for (std::uint32_t r = 0; r < repetitions; ++r)
    for (Sample& sample : samples) {
      refit.invalidate();
      refit.refit(0, palette);  // the first refit after a change visits all joints
      tools::bench::Stopwatch watch;
      for (const std::uint32_t node : sample.nodes) refit.refit(node, palette);
      watch.stop();
      sample.microseconds.push_back(watch.microseconds());
    }
}

NodeFacts mean_of(std::span<const NodeFacts> facts, const std::vector<std::uint32_t>& nodes) {
  NodeFacts mean;
  for (double NodeFacts::*fact :
       {&NodeFacts::joints, &NodeFacts::corners, &NodeFacts::flops, &NodeFacts::vertices}) {
    for (const std::uint32_t node : nodes) mean.*fact += facts[node].*fact;
    mean.*fact /= static_cast<double>(nodes.size());
  }
  return mean;
}

}  // namespace

std::vector<NodeFacts> facts_of(const SphereModel& model, const detail::SkinnedMesh& mesh) {
  VertexCounter vertices(mesh);
  std::vector<NodeFacts> all;
  for (std::uint32_t n = 0; n < model.tree.nodes.size(); ++n) {
    const std::span<const paper::JointSet> sets = model.bounds.sets_of(n);
    NodeFacts facts;
    for (const paper::JointSet& set : sets) {
      facts.joints += set.joint_count;
      facts.corners += set.corner_count;
    }
    facts.flops = paper::stated_flops(sets).total();
    facts.vertices = vertices.count(n, model.tree.triangles_of(model.tree.nodes[n]));
    all.push_back(facts);
  }
  return all;
}

std::vector<NodeClass> time_classes(const SphereModel& model, const Palette& palette,
                                    std::span<const NodeFacts> facts, double NodeFacts::*fact,
                                    std::uint32_t repetitions) {
  std::map<double, std::vector<std::uint32_t>> nodes_of;
  for (std::uint32_t n = 1; n < facts.size(); ++n) nodes_of[class_of(facts[n].*fact)].push_back(n);
  std::vector<Sample> samples;
  std::vector<NodeClass> classes;
  for (const auto& [number, nodes] : nodes_of) {
    if (nodes.size() < kFewest) continue;
    samples.push_back({evenly_chosen(nodes), {}});
    classes.push_back({static_cast<double>(nodes.size()), mean_of(facts, samples.back().nodes), 0});
  }
  time_in_turn(model, palette, repetitions, samples);
  for (std::size_t i = 0; i < classes.size(); ++i)
    classes[i].nanoseconds = 1000 * tools::output::median(samples[i].microseconds) /
                             static_cast<double>(samples[i].nodes.size());
  return classes;
}

detail::SkinnedMesh with_one_joint_set(const detail::SkinnedMesh& mesh) {
  detail::SkinnedMesh other = mesh;
  other.influences.clear();
  other.influence_begin = {0};
  scenes::SplitMix64 random(1);
  for (std::uint32_t vertex = 0; vertex < mesh.vertex_count(); ++vertex) {
    const auto weight = static_cast<float>(random.between(0.25, 0.75));
    other.influences.push_back({0, weight});
    other.influences.push_back({1, 1 - weight});
    other.influence_begin.push_back(static_cast<std::uint32_t>(other.influences.size()));
  }
  return other;
}

namespace {

/// Means over all spheres.
struct FlopCount {
  double sets = 0, joints = 0, corners = 0, counted = 0, stated = 0;
  double unexplained = 0;  ///< spheres whose counts differ for another reason than joining sets
};

FlopCount count_flops(const SphereModel& model, const Palette& palette) {
  FlopCount sum;
  const auto count = static_cast<std::uint32_t>(model.tree.nodes.size());
  for (std::uint32_t n = 0; n < count; ++n) {
    const std::span<const paper::JointSet> sets = model.bounds.sets_of(n);
    const int counted = counted_refit(model, n, palette).flops.total();
    const int stated = paper::stated_flops(sets).total();
    const auto set_count = static_cast<int>(sets.size());
    sum.sets += set_count;
    for (const paper::JointSet& set : sets) {
      sum.joints += set.joint_count;
      sum.corners += set.corner_count;
    }
    sum.counted += counted;
    sum.stated += stated;
    sum.unexplained += counted != stated + 2 * (set_count - 1);
  }
  for (double* mean : {&sum.sets, &sum.joints, &sum.corners, &sum.counted, &sum.stated})
    *mean /= count;
  return sum;
}

}  // namespace

Result<Table> flops_table() {
  Table table = {"refit_flops",
                 "Operations of a refit, means over all spheres",
                 {{"character", "character"},
                  {"spheres", "spheres"},
                  {"sets", "joint sets"},
                  {"joints", "joints in them"},
                  {"corners", "corners"},
                  {"counted_flops", "flops, counted"},
                  {"stated_flops", "flops, by the formula"},
                  {"unexplained", "spheres with other differences"}},
                 {},
                 "The formula is the sum of 18 p + 11 m + 8 p m - 2 over the joint sets, of p "
                 "joints and m corners each. One sphere is put around the corners of all sets, "
                 "which takes 2 flops more for each set after the first; the last column "
                 "counts spheres with any other difference."};
  for (const PaperCharacter& character : kPaperCharacters) {
    const Result<Specimen> specimen = make_specimen(character.options);
    if (!specimen) return specimen.error();
    const SphereModel model = paper::build_sphere_model(specimen->mesh);
    const FlopCount flops = count_flops(model, walking_palette(*specimen, 0.3f));
    table.rows.push_back({character.name, static_cast<double>(model.tree.nodes.size()), flops.sets,
                          flops.joints, flops.corners, flops.counted, flops.stated,
                          flops.unexplained});
  }
  return table;
}

namespace {

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

std::string text_of_classes(const Table& joints, const Table& vertices) {
  const std::size_t last = joints.rows.size() - 1;
  return "One refit of the paper's method takes " + shown(figure_at(joints, 0, "refit_ns")) +
         " ns if the vertices have " + shown(figure_at(joints, 0, "joints")) + " joint and " +
         shown(figure_at(joints, last, "refit_ns")) + " ns with " +
         shown(figure_at(joints, last, "joints")) +
         " joints in all joint sets. The geometry does not matter: if all vertices follow the "
         "same two joints, a refit takes " +
         range_of(vertices, "same_joints_ns") + " ns for " + range_of(vertices, "vertices") +
         " vertices. Large spheres of the creature take longer because their vertices have more "
         "joints.";
}

std::string text_of_all(const Table& all) {
  return "All spheres of two men take " + shown(figure_at(all, 0, "on_demand_ms")) +
         " ms on demand and " + shown(figure_at(all, 0, "bottom_up_ms")) +
         " ms bottom-up, in the paper " + shown(figure_at(all, 1, "on_demand_ms")) + " and " +
         shown(figure_at(all, 1, "bottom_up_ms")) +
         " ms. Since then, one sphere on demand has become faster by a factor of " +
         shown(figure_at(all, 2, "on_demand_ns")) + ", and all spheres bottom-up by a factor of " +
         shown(figure_at(all, 2, "bottom_up_ms")) +
         ", presumably because bottom-up refitting accesses memory in order and needs no weights.";
}

std::string text_of_rebuild(const Table& rebuild) {
  const std::size_t creature = rebuild.rows.size() - 1;
  return "Building a tree of the creature costs " +
         shown(figure_at(rebuild, creature, "paper_over_bottom_up")) +
         " times as much as its spheres refitted bottom-up (about " +
         shown(figure_at(rebuild, creature, "printed_over_bottom_up")) +
         " for trees of boxes, the paper cites) and " +
         shown(figure_at(rebuild, creature, "paper_over_on_demand")) +
         " times as much as all of them refitted on demand. Pelt's model costs " +
         shown(figure_at(rebuild, creature, "ratio")) + " times as much as all its boxes.";
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

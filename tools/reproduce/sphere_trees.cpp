/// The trees of section 5: spheres, levels and children before and after collapsing, the paper's
/// constant C (section 3.1) swept, and Pelt's own tree of the same characters.

#include "bench/method.hpp"
#include "model/model.hpp"
#include "paper/on_demand.hpp"
#include "tools/reproduce/experiment.hpp"
#include "tools/reproduce/paper_figures.hpp"
#include "tools/reproduce/specimen.hpp"

#include <algorithm>
#include <chrono>

namespace pelt::reproduce {
namespace {

using paper::LevelStatistics;
using paper::SphereTree;

double most_children(const std::vector<LevelStatistics>& levels) {
  std::uint32_t most = 0;
  for (const LevelStatistics& level : levels) most = std::max(most, level.max_children);
  return most;
}

std::vector<Cell> tree_row(const std::string& name, const SphereTree& tree) {
  const std::vector<LevelStatistics> levels = level_statistics(tree);
  return {name, static_cast<double>(tree.nodes.size()), static_cast<double>(levels.size()),
          most_children(levels)};
}

Table tree_table(const SphereTree& binary, const SphereTree& collapsed) {
  return {"sphere_trees",
          "Sphere tree of the creature, 13,590 triangles",
          {{"tree", "tree"},
           {"spheres", "spheres"},
           {"levels", "levels"},
           {"most_children", "most children of a node"}},
          {tree_row("binary", binary),
           {"binary, in the paper", kPaperSpheresBefore, kPaperDepthBefore, 2.0},
           tree_row("collapsed, C = 0.6", collapsed),
           {"collapsed, in the paper", kPaperSpheresAfter, kPaperDepthAfter, kPaperMostChildren}},
          ""};
}

Cell radius_at(const std::vector<LevelStatistics>& levels, std::size_t level) {
  if (level >= levels.size()) return {};
  return 100 * levels[level].mean_radius / levels[0].mean_radius;
}

template <std::size_t kCount>
Cell radius_at(const std::array<double, kCount>& radii, std::size_t level) {
  if (level >= radii.size()) return {};
  return 100 * radii[level] / radii[0];
}

/// The paper's units are unknown, so radii are told in percent of the root's.
Table level_table(const SphereTree& binary, const SphereTree& collapsed) {
  const std::vector<LevelStatistics> before = level_statistics(binary);
  const std::vector<LevelStatistics> after = level_statistics(collapsed);
  Table table = {"sphere_tree_levels",
                 "Mean radius on each level, in percent of the root's",
                 {{"level", "level"},
                  {"binary_percent", "binary"},
                  {"paper_binary_percent", "binary, in the paper"},
                  {"collapsed_percent", "collapsed"},
                  {"paper_collapsed_percent", "collapsed, in the paper"},
                  {"collapsed_spheres", "spheres, collapsed"}},
                 {},
                 "The paper prints the mean radii of all levels before, and after collapsing those "
                 "of Table 2."};
  for (std::size_t level = 0; level < before.size(); ++level) {
    const Cell spheres =
        level < after.size() ? Cell(static_cast<double>(after[level].nodes)) : Cell();
    table.rows.push_back({static_cast<double>(level + 1), radius_at(before, level),
                          radius_at(kPaperRadiiBefore, level), radius_at(after, level),
                          radius_at(kPaperReference, level), spheres});
  }
  return table;
}

/// What two creatures that walk into each other cost with one tree.
struct DescentCost {
  double node_pairs = 0, refits = 0, microseconds = 0;
};

/// The second creature stands in front of the first, turned to it, `distance` away.
detail::Palette facing_palette(const Specimen& specimen, float seconds, float distance) {
  const detail::Palette palette = walking_palette(specimen, seconds);
  std::vector<Matrix4> joints(palette.joints().begin(), palette.joints().end());
  for (Matrix4& joint : joints) {
    for (std::size_t column = 0; column < 4; ++column)
      for (const std::size_t row : {0u, 2u}) joint.m[4 * column + row] *= -1;
    joint.m[14] += distance;
  }
  detail::Palette facing(specimen.mesh.joint_count, specimen.mesh.rest_extent);
  (void)facing.set(joints);
  return facing;
}

constexpr float kFrames = 16;

DescentCost descent_cost(const Specimen& specimen, const paper::SphereModel& model) {
  paper::OnDemandBody a(specimen.mesh, model), b(specimen.mesh, model);
  paper::Scratch scratch;
  std::vector<Contact> contacts;
  DescentCost sum;
  for (float frame = 0; frame < kFrames; ++frame) {
    const detail::Palette palette_a = walking_palette(specimen, frame / 16);
    const detail::Palette palette_b =
        facing_palette(specimen, frame / 16 + 0.4f, 0.9f * frame / kFrames);
    double least = 1e9;
    for (int repetition = 0; repetition < 5; ++repetition) {
      a.invalidate();
      b.invalidate();
      contacts.clear();
      const std::uint64_t before = a.refits() + b.refits();
      const auto begin = std::chrono::steady_clock::now();
      const QueryStats work = collide(a, palette_a, b, palette_b, scratch, contacts, ~0u);
      const std::chrono::duration<double, std::micro> took =
          std::chrono::steady_clock::now() - begin;
      least = std::min(least, took.count());
      if (repetition > 0) continue;
      sum.node_pairs += static_cast<double>(work.node_pairs) / kFrames;
      sum.refits += static_cast<double>(a.refits() + b.refits() - before) / kFrames;
    }
    sum.microseconds += least / kFrames;
  }
  return sum;
}

Table sweep_table(const Specimen& specimen) {
  Table table = {"collapse_sweep",
                 "The constant C: two creatures at sixteen depths in each other",
                 {{"ratio", "C"},
                  {"spheres", "spheres"},
                  {"levels", "levels"},
                  {"most_children", "most children"},
                  {"sphere_pairs", "sphere tests a query"},
                  {"refits", "refits a query"},
                  {"query_us", "query [us]"}},
                 {},
                 "Means over the depths; the least of five times each. C = 1 takes out no sphere "
                 "but those that are as large as their parents."};
  for (const double ratio : {0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0}) {
    const paper::SphereModel model = paper::build_sphere_model(
        specimen.mesh, paper::BoundKind::optimised, static_cast<float>(ratio));
    const DescentCost cost = descent_cost(specimen, model);
    std::vector<Cell> row = tree_row("", model.tree);
    row[0] = ratio;
    for (const double figure : {cost.node_pairs, cost.refits, cost.microseconds})
      row.push_back(figure);
    table.rows.push_back(std::move(row));
  }
  return table;
}

double depth_of(const detail::Tree& tree) {
  std::vector<std::uint32_t> depth(tree.nodes.size(), 1);
  std::uint32_t deepest = 1;
  for (std::size_t n = 0; n < tree.nodes.size(); ++n) {
    const detail::Node& node = tree.nodes[n];
    for (std::uint32_t c = 0; c < node.child_count; ++c) depth[node.first_child + c] = depth[n] + 1;
    deepest = std::max(deepest, depth[n]);
  }
  return deepest;
}

std::vector<Cell> production_row(const char* name, const Specimen& specimen, double seconds) {
  const detail::Tree& tree = specimen.model.detail().tree;
  const auto nodes = static_cast<double>(tree.nodes.size());
  const auto clusters = static_cast<double>(tree.clusters.size());
  const auto triangles = static_cast<double>(tree.triangle_count());
  const auto bytes = static_cast<double>(specimen.model.memory_bytes());
  return {name,
          triangles,
          nodes,
          clusters,
          depth_of(tree),
          triangles / clusters,
          (clusters + nodes - 1) / nodes,
          static_cast<double>(tree.rest_positions.size()) / specimen.mesh.vertex_count(),
          bytes / triangles,
          1000 * seconds};
}

Result<Table> production_table() {
  Table table = {"pelt_trees",
                 "Pelt's own trees",
                 {{"character", "character"},
                  {"triangles", "triangles"},
                  {"nodes", "nodes"},
                  {"clusters", "clusters"},
                  {"levels", "levels"},
                  {"triangles_a_cluster", "triangles a cluster"},
                  {"slots_a_node", "slots a node"},
                  {"copies_a_vertex", "copies of a vertex"},
                  {"bytes_a_triangle", "bytes a triangle"},
                  {"build_ms", "build [ms]"}},
                 {},
                 "Bytes with vertices, influences and triangle numbers. Without sample poses."};
  for (const PaperCharacter& of : kPaperCharacters) {
    const Result<Specimen> specimen = make_specimen(of.options);
    if (!specimen) return specimen.error();
    const auto begin = std::chrono::steady_clock::now();
    if (const auto again = build_model(specimen->asset.mesh()); !again) return again.error();
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
    table.rows.push_back(production_row(of.name, *specimen, took.count()));
  }
  return table;
}

}  // namespace

Result<Section> sphere_trees(const Conditions&) {
  const Result<Specimen> creature = make_specimen(scenes::kCreature);
  if (!creature) return creature.error();
  const detail::SkinnedMesh& mesh = creature->mesh;
  const SphereTree binary = paper::build_binary_tree(mesh.rest_positions, mesh.triangles);
  const SphereTree collapsed = paper::collapse(binary);
  Result<Table> production = production_table();
  if (!production) return production.error();
  Section section;
  section.tables = {tree_table(binary, collapsed), level_table(binary, collapsed),
                    sweep_table(*creature), std::move(*production)};
  section.charts = {{"collapse_sweep",
                     "Cost of a query over the constant C",
                     "collapse_sweep",
                     "ratio",
                     {"query_us"},
                     "query [us]",
                     Axes::linear,
                     Better::lower}};
  return section;
}

}  // namespace pelt::reproduce

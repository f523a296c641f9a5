/// The trees of section 5: spheres, levels and children before and after collapsing, a sweep over
/// the paper's constant C (section 3.1), and Pelt's own tree of the same characters.

#include "evaluation/reproduce/characters.hpp"
#include "evaluation/reproduce/paper_figures.hpp"
#include "evaluation/reproduce/report.hpp"
#include "geometry/box4.hpp"
#include "model/model.hpp"
#include "paper/on_demand.hpp"
#include "text/format.hpp"
#include "tools/pelt/bench/stopwatch.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <span>

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

Table tree_table(std::size_t triangles, const SphereTree& binary, const SphereTree& collapsed) {
  return {"sphere_trees",
          "Sphere tree of the creature, " + text::with_commas(triangles) + " triangles",
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

/// The columns of one level of a tree. `printed` has the paper's mean radii.
struct LevelColumns {
  const std::vector<LevelStatistics>& levels;
  std::span<const double> printed;
};

void append_level(const LevelColumns& tree, std::size_t level, std::vector<Cell>& row) {
  const auto at = [&](const LevelStatistics& of) {
    return std::vector<Cell>{static_cast<double>(of.nodes), static_cast<double>(of.max_children),
                             100 * of.mean_radius / tree.levels[0].mean_radius};
  };
  std::vector<Cell> cells;
  if (level < tree.levels.size()) cells = at(tree.levels[level]);
  cells.resize(3);
  row.insert(row.end(), cells.begin(), cells.end());
  const bool is_printed = level < tree.printed.size();
  row.push_back(is_printed ? Cell(100 * tree.printed[level] / tree.printed[0]) : Cell());
  row.push_back(is_printed ? Cell(tree.printed[level]) : Cell());
}

/// The paper's units are unknown, so radii are also given in percent of the root's radius.
Table level_table(const SphereTree& binary, const SphereTree& collapsed) {
  const std::vector<LevelStatistics> before = level_statistics(binary);
  const std::vector<LevelStatistics> after = level_statistics(collapsed);
  Table table = {"sphere_tree_levels",
                 "Mean radius on each level of the creature's sphere tree, before and after "
                 "collapsing",
                 {{"level", "level"}},
                 {},
                 "The paper's radii are in units of its own; after collapsing they are those of "
                 "its Table 2."};
  for (const std::string tree : {"binary", "collapsed"}) {
    table.columns.push_back({tree + "_spheres", tree + ": spheres"});
    table.columns.push_back({tree + "_most_children", tree + ": most children"});
    table.columns.push_back({tree + "_percent", tree + ": mean radius [% of the root's]"});
    table.columns.push_back({"paper_" + tree + "_percent", tree + ", in the paper [%]"});
    table.columns.push_back({"paper_" + tree + "_radius", tree + ", in the paper [its units]"});
  }
  for (std::size_t level = 0; level < std::max(before.size(), kPaperRadiiBefore.size()); ++level) {
    table.rows.push_back({static_cast<double>(level + 1)});
    append_level({before, kPaperRadiiBefore}, level, table.rows.back());
    append_level({after, kPaperReference}, level, table.rows.back());
  }
  return table;
}

/// The cost of two creatures that walk into each other, with one tree.
struct DescentCost {
  double node_pairs = 0, refits = 0, microseconds = 0;
};

/// The second creature is `distance` in front of the first and faces it.
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
constexpr int kRepetitions = 5;

/// A pair of creatures with one of the compared trees.
struct Pair {
  Pair(const Specimen& specimen, const paper::SphereModel& model)
      : a(specimen.mesh, model), b(specimen.mesh, model) {}

  paper::OnDemandBody a, b;
  DescentCost cost;
};

/// Adds the cost of one frame: the least of the repetitions.
void add_frame(const detail::Palette& palette_a, const detail::Palette& palette_b, Pair& pair) {
  paper::Scratch scratch;
  std::vector<Contact> contacts;
  double least = 1e9;
  for (int repetition = 0; repetition < kRepetitions; ++repetition) {
    pair.a.invalidate();
    pair.b.invalidate();
    contacts.clear();
    const std::uint64_t before = pair.a.refits() + pair.b.refits();
    tools::bench::Stopwatch watch;
    const QueryStats work = collide(pair.a, palette_a, pair.b, palette_b, scratch, contacts, ~0u);
    watch.stop();
    least = std::min(least, watch.microseconds());
    if (repetition > 0) continue;
    pair.cost.node_pairs += static_cast<double>(work.node_pairs) / kFrames;
    pair.cost.refits += static_cast<double>(pair.a.refits() + pair.b.refits() - before) / kFrames;
  }
  pair.cost.microseconds += least / kFrames;
}

/// Measures all trees in turn at every frame, so that changes in the load of the machine affect all
/// alike.
std::vector<DescentCost> descent_costs(const Specimen& specimen,
                                       const std::vector<paper::SphereModel>& models) {
  std::vector<Pair> pairs;
  for (const paper::SphereModel& model : models) pairs.emplace_back(specimen, model);
  for (float frame = 0; frame < kFrames; ++frame) {
    const detail::Palette palette_a = walking_palette(specimen, frame / 16);
    const detail::Palette palette_b =
        facing_palette(specimen, frame / 16 + 0.4f, 0.9f * frame / kFrames);
    for (Pair& pair : pairs) add_frame(palette_a, palette_b, pair);
  }
  std::vector<DescentCost> costs;
  for (const Pair& pair : pairs) costs.push_back(pair.cost);
  return costs;
}

Table sweep_table(const Specimen& specimen) {
  constexpr std::array kRatios = {0.3, 0.4, 0.5, kPaperCollapseRatio, 0.7, 0.8, 0.9, 1.0};
  Table table = {
      "collapse_sweep",
      "The constant C: two creatures at sixteen depths of intersection",
      {{"ratio", "C"},
       {"spheres", "spheres"},
       {"levels", "levels"},
       {"most_children", "most children"},
       {"sphere_pairs", "sphere tests per query"},
       {"refits", "refits per query"},
       {"query_us", "query [us]"}},
      {},
      "Means over the depths of the least of five times. C = 1 deletes only spheres that "
      "are as large as their parents."};
  std::vector<paper::SphereModel> models;
  for (const double ratio : kRatios)
    models.push_back(paper::build_sphere_model(specimen.mesh, paper::BoundKind::optimised,
                                               static_cast<float>(ratio)));
  const std::vector<DescentCost> costs = descent_costs(specimen, models);
  for (std::size_t i = 0; i < models.size(); ++i) {
    std::vector<Cell> row = tree_row("", models[i].tree);
    row[0] = kRatios[i];
    for (const double figure : {costs[i].node_pairs, costs[i].refits, costs[i].microseconds})
      row.push_back(figure);
    table.rows.push_back(std::move(row));
  }
  return table;
}

/// The number of ancestors of each node.
std::vector<std::uint32_t> depths_of(const detail::Tree& tree) {
  std::vector<std::uint32_t> depths(tree.nodes.size(), 0);
  for (std::size_t n = 0; n < tree.nodes.size(); ++n) {
    const detail::Node& node = tree.nodes[n];
    for (std::uint32_t c = 0; c < node.child_count; ++c)
      depths[node.first_child + c] = depths[n] + 1;
  }
  return depths;
}

double level_count(const detail::Tree& tree) {
  const std::vector<std::uint32_t> depths = depths_of(tree);
  return 1 + *std::max_element(depths.begin(), depths.end());
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
          level_count(tree),
          triangles / clusters,
          (clusters + nodes - 1) / nodes,
          static_cast<double>(tree.rest_positions.size()) / specimen.mesh.vertex_count(),
          bytes / triangles,
          1000 * seconds};
}

Result<Table> production_table() {
  Table table = {
      "pelt_trees",
      "Pelt's own trees",
      {{"character", "character"},
       {"triangles", "triangles"},
       {"nodes", "nodes"},
       {"clusters", "clusters"},
       {"levels", "levels"},
       {"triangles_a_cluster", "triangles per cluster"},
       {"slots_a_node", "slots per node"},
       {"copies_a_vertex", "copies per vertex"},
       {"bytes_a_triangle", "bytes per triangle"},
       {"build_ms", "build [ms]"}},
      {},
      "Bytes include vertices, influences and triangle numbers. Built without sample poses."};
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

/// Half the diagonal of the box around the rest vertices of a node's pool and of the pools below.
std::vector<double> rest_radii(const detail::Tree& tree) {
  std::vector<detail::Box4> boxes(tree.nodes.size(), detail::empty_box());
  for (std::size_t n = tree.nodes.size(); n-- > 0;) {
    const detail::Node& node = tree.nodes[n];
    for (std::uint32_t v = 0; v < node.vertex_count; ++v) {
      const Vec3& p = tree.rest_positions[node.first_vertex + v];
      const detail::Float4 point(p.x, p.y, p.z, 0);
      boxes[n] = unite(boxes[n], {point, point});
    }
    for (std::uint32_t c = 0; c < node.child_count; ++c)
      boxes[n] = unite(boxes[n], boxes[node.first_child + c]);
  }
  std::vector<double> radii;
  for (const detail::Box4& box : boxes) {
    const detail::Float4 side = box.high - box.low;
    radii.push_back(0.5 * std::hypot(side[0], side[1], side[2]));
  }
  return radii;
}

/// The statistics of the paper for Pelt's tree.
Table production_level_table(const Specimen& creature) {
  struct Level {
    double nodes = 0, clusters = 0, slots = 0, most_slots = 0, radius = 0;
  };
  const detail::Tree& tree = creature.model.detail().tree;
  const std::vector<std::uint32_t> depths = depths_of(tree);
  const std::vector<double> radii = rest_radii(tree);
  std::vector<Level> levels;
  for (std::size_t n = 0; n < depths.size(); ++n) {
    if (depths[n] >= levels.size()) levels.resize(depths[n] + 1);
    Level& level = levels[depths[n]];
    const double clusters = tree.nodes[n].cluster_count;
    const double slots = clusters + tree.nodes[n].child_count;
    ++level.nodes;
    level.clusters += clusters;
    level.slots += slots;
    level.most_slots = std::max(level.most_slots, slots);
    level.radius += radii[n];
  }
  Table table = {"pelt_tree_levels",
                 "The levels of Pelt's tree of the creature",
                 {{"level", "level"},
                  {"nodes", "nodes"},
                  {"clusters", "clusters in them"},
                  {"slots_a_node", "slots a node"},
                  {"most_slots", "most slots"},
                  {"radius_percent", "mean radius [% of the root's]"}},
                 {},
                 "A slot is a cluster of up to 16 triangles or a child node. Radius: half the "
                 "diagonal of the box of everything below, in the rest pose."};
  for (std::size_t i = 0; i < levels.size(); ++i) {
    const Level& level = levels[i];
    table.rows.push_back({static_cast<double>(i + 1), level.nodes, level.clusters,
                          level.slots / level.nodes, level.most_slots,
                          100 * level.radius / level.nodes / levels[0].radius});
  }
  return table;
}

/// "0.6", the constant of the row in which a query is fastest.
std::string text_of_sweep(const Table& sweep) {
  const std::size_t ratio = column_of(sweep, "ratio"), query = column_of(sweep, "query_us");
  const auto faster = [&](const std::vector<Cell>& a, const std::vector<Cell>& b) {
    return *a[query].figure < *b[query].figure;
  };
  const auto& best = *std::min_element(sweep.rows.begin(), sweep.rows.end(), faster);
  const auto& papers = *std::find_if(sweep.rows.begin(), sweep.rows.end(), [&](const auto& row) {
    return row[ratio].figure == kPaperCollapseRatio;
  });
  return "The paper uses the constant C = " + shown(papers[ratio]) + ", with which a query takes " +
         shown(papers[query]) + " us here. The fastest is C = " + shown(best[ratio]) + " with " +
         shown(best[query]) + " us.";
}

std::string text_of_trees(const Table& trees) {
  const auto figure = [&](std::size_t row, const char* key) {
    return shown(trees.rows[row][column_of(trees, key)]);
  };
  return "Collapsing leaves " + figure(2, "spheres") + " of the creature's " +
         figure(0, "spheres") + " spheres on " + figure(2, "levels") + " levels instead of " +
         figure(0, "levels") + "; in the paper " + figure(3, "spheres") + " of " +
         figure(1, "spheres") + " on " + figure(3, "levels") + " instead of " +
         figure(1, "levels") + ".";
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
  section.tables = {tree_table(mesh.triangles.size(), binary, collapsed),
                    level_table(binary, collapsed), sweep_table(*creature), std::move(*production),
                    production_level_table(*creature)};
  section.text = {text_of_trees(section.tables[0]), text_of_sweep(section.tables[2])};
  section.charts = {
      {"tree_radii",
       "Mean radius on each level, before and after collapsing",
       "sphere_tree_levels",
       "level",
       {"binary_percent", "paper_binary_percent", "collapsed_percent", "paper_collapsed_percent"},
       "mean radius [% of the root's]",
       Axes::logarithmic_y,
       Better::neither},
      {"collapse_sweep",
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

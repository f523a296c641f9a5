/// Table 2 of the paper: mean radii of refitted spheres, level by level, between those of the rest
/// pose and the least that any refit could reach; and the same comparison for Pelt's boxes.

#include "evaluation/reproduce/characters.hpp"
#include "evaluation/reproduce/figures.hpp"
#include "evaluation/reproduce/paper_figures.hpp"
#include "model/model.hpp"
#include "model/node_box.hpp"
#include "model/unpack.hpp"
#include "paper/eager.hpp"
#include "paper/min_sphere.hpp"
#include "paper/on_demand.hpp"
#include "skin/skin.hpp"

#include <algorithm>

namespace pelt::reproduce {
namespace {

using detail::Palette;
using paper::Node;
using paper::SphereModel;
using paper::SphereTree;

/// At this time of the walk, both legs and both arms are apart.
constexpr float kSeconds = 0.3f;

using Radii = std::vector<float>;  // by node

Radii refitted(const SphereModel& model, const Palette& palette) {
  paper::Refit refit(model, static_cast<std::uint32_t>(palette.joints().size()));
  Radii radii;
  for (std::uint32_t n = 0; n < model.tree.nodes.size(); ++n)
    radii.push_back(refit.sphere(n, palette)[3]);
  return radii;
}

Vec3 image(const Matrix4& m, const Vec3& p) {
  const auto row = [&](std::size_t r) {
    return m.m[r] * p.x + m.m[4 + r] * p.y + m.m[8 + r] * p.z + m.m[12 + r];
  };
  return {row(0), row(1), row(2)};
}

/// The centres of a node's spheres R_1 ... R_m (eq. 5).
std::vector<Vec3> corner_centres(const SphereModel& model, std::uint32_t node,
                                 const Palette& palette) {
  const paper::WeightBounds& bounds = model.bounds;
  std::vector<Vec3> centres;
  for (const paper::JointSet& set : bounds.sets_of(node)) {
    const float* weight = &bounds.corners[set.first_corner];
    for (std::uint32_t corner = 0; corner < set.corner_count; ++corner) {
      Vec3 centre = {0, 0, 0};
      for (std::uint32_t j = 0; j < set.joint_count; ++j, ++weight) {
        const Matrix4& joint = palette[bounds.joints[set.first_joint + j]];
        const Vec3 p = image(joint, model.tree.nodes[node].rest.centre);
        centre = {centre.x + *weight * p.x, centre.y + *weight * p.y, centre.z + *weight * p.z};
      }
      centres.push_back(centre);
    }
  }
  return centres;
}

/// The smallest spheres around the corner spheres. These are all as large as the rest sphere,
/// because the generated character's joints only rotate and translate.
Radii smallest_around_corners(const SphereModel& model, const Palette& palette) {
  Radii radii;
  for (std::uint32_t n = 0; n < model.tree.nodes.size(); ++n)
    radii.push_back(paper::min_sphere(corner_centres(model, n, palette)).radius +
                    model.tree.nodes[n].rest.radius);
  return radii;
}

Radii bottom_up(const detail::SkinnedMesh& mesh, const SphereTree& tree, const Palette& palette) {
  paper::EagerBody body(mesh, tree);
  body.update(palette);
  Radii radii;
  for (const detail::Float4& sphere : body.spheres()) radii.push_back(sphere[3]);
  return radii;
}

/// The smallest spheres around the posed vertices.
Radii best(const detail::SkinnedMesh& mesh, const SphereTree& tree, const Palette& palette) {
  std::vector<Vec3> posed(mesh.vertex_count());
  detail::posed_vertices(mesh, palette, posed);
  Radii radii;
  std::vector<Vec3> points;
  for (const Node& node : tree.nodes) {
    points.clear();
    for (const std::uint32_t triangle : tree.triangles_of(node))
      for (const std::uint32_t vertex : mesh.triangles[triangle]) points.push_back(posed[vertex]);
    radii.push_back(paper::min_sphere(points).radius);
  }
  return radii;
}

Radii reference(const SphereTree& tree) {
  Radii radii;
  for (const Node& node : tree.nodes) radii.push_back(node.rest.radius);
  return radii;
}

/// A column of Table 2: our figure and the paper's.
struct RadiusColumn {
  const char *key, *title;
  std::vector<paper::LevelStatistics> levels;
  const std::array<double, 9>* printed;
};

std::vector<RadiusColumn> radius_columns(const Specimen& creature, const Palette& palette) {
  const detail::SkinnedMesh& mesh = creature.mesh;
  const SphereModel optimised = paper::build_sphere_model(mesh);
  const SphereModel plain = paper::build_sphere_model(mesh, paper::BoundKind::plain);
  const SphereTree& tree = optimised.tree;
  const auto levels = [&](const Radii& radii) { return level_statistics(tree, radii); };
  return {{"reference", "reference", levels(reference(tree)), &kPaperReference},
          {"eq2", "on demand, eq. 2", levels(refitted(plain, palette)), nullptr},
          {"on_demand", "on demand", levels(refitted(optimised, palette)), &kPaperOnDemand},
          {"exact_corners", "on demand, exact ball of the corner balls",
           levels(smallest_around_corners(optimised, palette)), nullptr},
          {"bottom_up", "bottom-up", levels(bottom_up(mesh, tree, palette)), &kPaperBottomUp},
          {"best", "best", levels(best(mesh, tree, palette)), &kPaperBest}};
}

Table radius_table(const std::vector<RadiusColumn>& columns) {
  Table table = {"radii",
                 "Mean radii of the creature's spheres on each level, walking (Table 2)",
                 {{"level", "level"}, {"spheres", "spheres"}},
                 {},
                 "In units of the character, which is 1.8 tall."};
  for (const RadiusColumn& column : columns) table.columns.push_back({column.key, column.title});
  for (std::size_t level = 0; level < columns[0].levels.size(); ++level) {
    table.rows.push_back(
        {static_cast<double>(level + 1), static_cast<double>(columns[0].levels[level].nodes)});
    for (const RadiusColumn& column : columns)
      table.rows.back().push_back(column.levels[level].mean_radius);
  }
  return table;
}

Table printed_radius_table(const std::vector<RadiusColumn>& columns) {
  Table table = {
      "radii_printed", "Table 2 in the paper, in its own units", {{"level", "level"}}, {}, ""};
  for (std::size_t level = 0; level < kPaperBest.size(); ++level)
    table.rows.push_back({static_cast<double>(level + 1)});
  for (const RadiusColumn& column : columns) {
    if (column.printed == nullptr) continue;
    table.columns.push_back({column.key, column.title});
    for (std::size_t level = 0; level < kPaperBest.size(); ++level)
      table.rows[level].push_back((*column.printed)[level]);
  }
  return table;
}

/// Ratios of the radii to the best ones; only these can be compared with the paper's.
Table ratio_table(const std::vector<RadiusColumn>& columns) {
  Table table = {"radii_over_best",
                 "Radii relative to the best possible refit, ours and the paper's",
                 {{"level", "level"}},
                 {},
                 ""};
  const std::vector<paper::LevelStatistics>& least = columns.back().levels;
  const auto add = [&](const RadiusColumn& column, bool is_printed) {
    table.columns.push_back({std::string(is_printed ? "paper_" : "") + column.key,
                             std::string(column.title) + (is_printed ? ", in the paper" : "")});
    for (std::size_t level = 0; level < least.size(); ++level) {
      Cell cell;
      if (!is_printed)
        cell = column.levels[level].mean_radius / least[level].mean_radius;
      else if (level < kPaperBest.size())
        cell = (*column.printed)[level] / kPaperBest[level];
      table.rows[level].push_back(cell);
    }
  };
  for (std::size_t level = 0; level < least.size(); ++level)
    table.rows.push_back({static_cast<double>(level + 1)});
  for (const RadiusColumn& column : columns) {
    if (column.levels.data() == least.data()) break;
    add(column, false);
    if (column.printed != nullptr) add(column, true);
  }
  return table;
}

/// A box, by its lowest and highest corner.
struct Box {
  std::array<float, 3> low = {HUGE_VALF, HUGE_VALF, HUGE_VALF};
  std::array<float, 3> high = {-HUGE_VALF, -HUGE_VALF, -HUGE_VALF};

  void include(const Vec3& p) {
    const std::array<float, 3> at = {p.x, p.y, p.z};
    for (std::size_t a = 0; a < 3; ++a) {
      low[a] = std::min(low[a], at[a]);
      high[a] = std::max(high[a], at[a]);
    }
  }
  void include(const Box& other) {
    include(Vec3{other.low[0], other.low[1], other.low[2]});
    include(Vec3{other.high[0], other.high[1], other.high[2]});
  }
  double area() const {
    const auto side = [&](std::size_t a) { return static_cast<double>(high[a] - low[a]); };
    return 2 * (side(0) * side(1) + side(1) * side(2) + side(2) * side(0));
  }
};

/// The box of the posed vertices below each node.
std::vector<Box> exact_boxes(const Specimen& specimen, const Palette& palette) {
  const detail::Tree& tree = specimen.model.detail().tree;
  const detail::SkinnedMesh vertices = detail::unpack_vertices(tree);
  std::vector<Box> boxes(tree.nodes.size());
  for (std::size_t n = tree.nodes.size(); n-- > 0;) {
    const detail::Node& node = tree.nodes[n];
    for (std::uint32_t v = 0; v < node.vertex_count; ++v)
      boxes[n].include(detail::posed_vertex(vertices, palette, node.first_vertex + v));
    for (std::uint32_t c = 0; c < node.child_count; ++c)
      boxes[n].include(boxes[node.first_child + c]);
  }
  return boxes;
}

/// The figures of the nodes of one level.
struct BoxLevel {
  double nodes = 0, affine = 0, area = 0, exact_area = 0;
};

std::vector<BoxLevel> box_levels(const Specimen& specimen, const Palette& palette) {
  const detail::Model& model = specimen.model.detail();
  const std::vector<Box> exact = exact_boxes(specimen, palette);
  std::vector<std::size_t> level_of(exact.size(), 0);
  std::vector<BoxLevel> levels;
  for (std::uint32_t n = 0; n < exact.size(); ++n) {
    const detail::Node& node = model.tree.nodes[n];
    for (std::uint32_t c = 0; c < node.child_count; ++c)
      level_of[node.first_child + c] = level_of[n] + 1;
    if (level_of[n] == levels.size()) levels.emplace_back();
    const detail::Box4 bound = detail::node_box(model.bounds, n, palette);
    Box box;
    box.include(Vec3{bound.low[0], bound.low[1], bound.low[2]});
    box.include(Vec3{bound.high[0], bound.high[1], bound.high[2]});
    BoxLevel& level = levels[level_of[n]];
    ++level.nodes;
    level.affine += model.bounds.nodes[n].is_affine();
    level.area += box.area();
    level.exact_area += exact[n].area();
  }
  return levels;
}

Table box_table(const Specimen& specimen, const Palette& palette) {
  Table table = {
      "boxes",
      "Pelt's boxes of the same creature in the same pose",
      {{"level", "level"},
       {"nodes", "nodes"},
       {"affine_percent", "with the affine bound [%]"},
       {"area", "mean surface of the bound [units^2]"},
       {"exact_area", "of the exact box [units^2]"},
       {"ratio", "bound / exact"}},
      {},
      "A bound is a box from the joint matrices alone: the union of a box for each joint, "
      "or, if it is tighter, an affine map of the rest box with a margin. Clusters "
      "are below; their boxes are exact."};
  const std::vector<BoxLevel> levels = box_levels(specimen, palette);
  for (std::size_t i = 0; i < levels.size(); ++i) {
    const BoxLevel& level = levels[i];
    table.rows.push_back({static_cast<double>(i + 1), level.nodes, 100 * level.affine / level.nodes,
                          level.area / level.nodes, level.exact_area / level.nodes,
                          level.area / level.exact_area});
  }
  return table;
}

/// Number of levels on which the first column of `table` has the smaller radius.
std::size_t levels_won(const Table& table, const char* key, const char* other) {
  const std::size_t a = column_of(table, key), b = column_of(table, other);
  return static_cast<std::size_t>(
      std::count_if(table.rows.begin(), table.rows.end(), [&](const std::vector<Cell>& row) {
        return row[a].figure && row[b].figure && *row[a].figure < *row[b].figure;
      }));
}

std::string levels_in_words(std::size_t won, const Table& table) {
  return std::to_string(won) + " of " + std::to_string(table.rows.size()) + " levels";
}

std::string text_of_bottom_up(const Table& ratios) {
  const auto last = [&](const char* key) {
    return shown(ratios.rows.back()[column_of(ratios, key)]);
  };
  return "In the paper, refitting on demand gives tighter spheres than bottom-up on " +
         levels_in_words(levels_won(ratios, "paper_on_demand", "paper_bottom_up"), ratios) +
         ", here on " + levels_in_words(levels_won(ratios, "on_demand", "bottom_up"), ratios) +
         ": our bottom-up refit puts the smallest sphere around each posed triangle, so on the "
         "last level its radius is " +
         last("bottom_up") + " times the best, and the paper's " + last("paper_bottom_up") +
         ". On demand, both are near the best, and nearer on deeper levels.";
}

std::string text_of_bounds(const Table& ratios) {
  const auto first = [&](const char* key) {
    return shown(ratios.rows.front()[column_of(ratios, key)]);
  };
  return "The optimised bound is tighter than the bound of equation 2 on " +
         levels_in_words(levels_won(ratios, "on_demand", "eq2"), ratios) +
         ". On other levels, such as the root (" + first("on_demand") + " and " + first("eq2") +
         " times the best), it is looser because its centre is the mean of the corners' centres "
         "(equation 5), not the best one. The exact ball around the corners' balls has " +
         first("exact_corners") + " times the best radius there.";
}

}  // namespace

Result<Section> tightness(const Conditions& conditions) {
  const Result<Specimen> creature = make_specimen(scenes::kCreature);
  if (!creature) return creature.error();
  const Palette palette = walking_palette(*creature, kSeconds);
  const std::vector<RadiusColumn> columns = radius_columns(*creature, palette);
  Section section;
  section.tables = {radius_table(columns), printed_radius_table(columns), ratio_table(columns),
                    box_table(*creature, palette)};
  section.text = {text_of_bottom_up(section.tables[2]), text_of_bounds(section.tables[2])};
  section.charts = {
      {"radii",
       "Mean radius over the best",
       "radii_over_best",
       "level",
       {"eq2", "on_demand", "paper_on_demand", "exact_corners", "bottom_up", "paper_bottom_up"},
       "radius / best",
       Axes::linear,
       Better::lower,
       0.9}};
  section.pictures = {level_picture(*creature, palette, conditions)};
  return section;
}

}  // namespace pelt::reproduce

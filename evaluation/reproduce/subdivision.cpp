/// Table 3 and Figure 7 of the paper: two dwarves whose triangles are repeatedly cut into four,
/// once apart and once intersecting.

#include "evaluation/reproduce/subdivision.hpp"

#include "base/assert.hpp"
#include "base/vec3.hpp"
#include "evaluation/methods/lab_methods.hpp"
#include "evaluation/reproduce/characters.hpp"
#include "evaluation/reproduce/figures.hpp"
#include "evaluation/reproduce/paper_figures.hpp"
#include "evaluation/reproduce/scene_figures.hpp"
#include "paper/on_demand.hpp"
#include "paper/sphere_tree.hpp"
#include "tools/pelt/bench/stopwatch.hpp"
#include "tools/pelt/output/statistics.hpp"
#include "tools/pelt/scene/scene_query.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace pelt::reproduce {
namespace {

using methods::MethodKind;
using tools::bench::Question;

using Edge = std::pair<std::uint32_t, std::uint32_t>;  // lower vertex first
using Weights = std::map<std::uint16_t, float>;        // of joints

/// The edges in the order in which triangles first use them: new vertex V + i is on edge i.
struct Edges {
  explicit Edges(std::span<const Triangle> triangles) {
    for (const Triangle& t : triangles)
      for (std::size_t i = 0; i < 3; ++i) {
        const Edge edge = std::minmax(t[i], t[(i + 1) % 3]);
        if (number.emplace(edge, list.size()).second) list.push_back(edge);
      }
  }

  std::vector<Edge> list;
  std::map<Edge, std::size_t> number;
};

Weights weights_of(const asset::Asset& asset, std::uint32_t vertex) {
  Weights weights;
  const std::size_t slots = asset.influences_per_vertex;
  for (std::size_t i = slots * vertex; i < slots * (vertex + 1); ++i)
    if (asset.weights[i] > 0) weights[asset.joint_indices[i]] += asset.weights[i];
  return weights;
}

Weights mean(const Weights& a, const Weights& b) {
  Weights all;
  for (const Weights* one : {&a, &b})
    for (const auto& [joint, weight] : *one) all[joint] += 0.5f * weight;
  return all;
}

void set_weights(const std::vector<Weights>& of_vertices, asset::Asset& asset) {
  std::size_t slots = 1;
  for (const Weights& weights : of_vertices) slots = std::max(slots, weights.size());
  asset.influences_per_vertex = static_cast<std::uint32_t>(slots);
  asset.joint_indices.assign(slots * of_vertices.size(), 0);
  asset.weights.assign(slots * of_vertices.size(), 0);
  for (std::size_t v = 0; v < of_vertices.size(); ++v) {
    std::size_t slot = slots * v;
    for (const auto& [joint, weight] : of_vertices[v]) {
      asset.joint_indices[slot] = joint;
      asset.weights[slot++] = weight;
    }
  }
}

std::vector<Triangle> cut(std::span<const Triangle> triangles, const Edges& edges,
                          std::size_t vertex_count) {
  std::vector<Triangle> fine;
  for (const Triangle& t : triangles) {
    std::array<std::uint32_t, 3> middle;
    for (std::size_t i = 0; i < 3; ++i)
      middle[i] = static_cast<std::uint32_t>(vertex_count +
                                             edges.number.at(std::minmax(t[i], t[(i + 1) % 3])));
    for (std::size_t i = 0; i < 3; ++i) fine.push_back({t[i], middle[i], middle[(i + 2) % 3]});
    fine.push_back({middle[0], middle[1], middle[2]});
  }
  return fine;
}

detail::Vec3d posed(const asset::Asset& asset, std::uint32_t vertex,
                    std::span<const Matrix4> palette) {
  const detail::Vec3d p(asset.rest_positions[vertex]);
  detail::Vec3d sum(0, 0, 0);
  for (const auto& [joint, weight] : weights_of(asset, vertex)) {
    const auto& m = palette[joint].m;
    const auto row = [&](std::size_t r) {
      const auto at = [&](std::size_t column) { return static_cast<double>(m[4 * column + r]); };
      return at(0) * p.x + at(1) * p.y + at(2) * p.z + at(3);
    };
    sum = sum + static_cast<double>(weight) * detail::Vec3d(row(0), row(1), row(2));
  }
  return sum;
}

}  // namespace

asset::Asset subdivided(const asset::Asset& asset) {
  const Edges edges(asset.triangles);
  asset::Asset fine = asset;
  std::vector<Weights> weights;
  for (std::uint32_t v = 0; v < asset.rest_positions.size(); ++v)
    weights.push_back(weights_of(asset, v));
  for (const auto& [a, b] : edges.list) {
    const Vec3 &p = asset.rest_positions[a], &q = asset.rest_positions[b];
    fine.rest_positions.push_back({0.5f * (p.x + q.x), 0.5f * (p.y + q.y), 0.5f * (p.z + q.z)});
    weights.push_back(mean(weights[a], weights[b]));
  }
  set_weights(weights, fine);
  fine.triangles = cut(asset.triangles, edges, asset.rest_positions.size());
  for (asset::Part& part : fine.parts) {
    part.first_triangle *= 4;
    part.triangle_count *= 4;
  }
  return fine;
}

double drift_of(const asset::Asset& coarse, const asset::Asset& fine,
                std::span<const Matrix4> palette) {
  const Edges edges(coarse.triangles);
  double largest = 0;
  for (std::uint32_t i = 0; i < edges.list.size(); ++i) {
    const auto [a, b] = edges.list[i];
    const detail::Vec3d middle = 0.5 * (posed(coarse, a, palette) + posed(coarse, b, palette));
    const auto vertex = static_cast<std::uint32_t>(coarse.rest_positions.size() + i);
    largest = std::max(largest, std::sqrt(squared_length(posed(fine, vertex, palette) - middle)));
  }
  return largest;
}

namespace {

/// Distances of the two: bounds overlap; hands touch.
constexpr double kApart = 0.85, kInterfering = 0.73;

constexpr std::array kMethods = {methods::kPaper, lab::kPaperEager, methods::kEager,
                                 methods::kOnDemand};

/// The dwarf and its subdivisions.
Result<std::vector<scenes::Character>> subdivisions(std::uint32_t most) {
  const Result<scenes::Character> dwarf = scenes::generate_character(scenes::kDwarf);
  if (!dwarf) return dwarf.error();
  std::vector<scenes::Character> all = {*dwarf};
  while (all.size() <= most) {
    all.push_back(all.back());
    all.back().asset = subdivided(all[all.size() - 2].asset);
  }
  return all;
}

/// The drift of all levels so far, in percent of the character's height.
double drift(const std::vector<scenes::Character>& dwarves, std::size_t level, double before) {
  if (level == 0) return 0;
  const scenes::Scene scene = facing_pair(dwarves[0], kInterfering);
  asset::SampleScratch scratch;
  std::vector<Matrix4> palette(dwarves[0].asset.joints.size());
  scenes::instance_palette(scene, 0, 0, scratch, palette);
  constexpr double kHeight = 1.8;
  return before + 100 / kHeight * drift_of(dwarves[level - 1].asset, dwarves[level].asset, palette);
}

double sphere_count(const scenes::Character& dwarf) {
  const asset::Asset& asset = dwarf.asset;
  return static_cast<double>(
      paper::build_sphere_tree(asset.rest_positions, asset.triangles).nodes.size());
}

const QueryStats& work_of(const tools::bench::SceneFigures& figures, MethodKind method) {
  return figures_of(figures, method.name, Question::all).answer.work;
}

/// A position of the two, and the paper's figures for it by level. For the first position, the
/// paper prints only speed-ups.
struct Position {
  const char *id, *title;
  double distance;
  std::span<const double> speed_ups;
};

/// A table for our figures; the paper's are in a table of their own.
Table empty_table(const Position& position) {
  Table table = {position.id,
                 position.title,
                 {{"subdivisions", "subdivisions"},
                  {"triangles", "triangles"},
                  {"spheres", "spheres"},
                  {"contacts", "contacts"}},
                 {},
                 "One frame of one pose; medians of repetitions, one thread, caches hot. Speed-up: "
                 "the time of the second method divided by that of the first."};
  for (const MethodKind method : kMethods)
    table.columns.push_back({std::string(method.name) + "_us", title_of(method) + " [us]"});
  for (const Column& column : {Column{"paper_refits", "paper on demand: refits"},
                               {"paper_joints", "joints of the root's sphere"},
                               {"paper_sphere_pairs", "paper on demand: sphere tests"},
                               {"paper_eager_sphere_pairs", "paper bottom-up: sphere tests"},
                               {"paper_speed_up", "speed-up, paper on demand against bottom-up"},
                               {"printed_speed_up", "the same in the paper"},
                               {"speed_up", "speed-up, Pelt against Pelt eager"}})
    table.columns.push_back(column);
  return table;
}

/// The number of joints in all joint sets of the root's sphere, which determines the cost of its
/// refit.
double joints_of_root(const scenes::Character& dwarf) {
  const Result<Specimen> specimen = make_specimen(dwarf.asset);
  PELT_ASSERT(specimen);
  const paper::SphereModel model = paper::build_sphere_model(specimen->mesh);
  double joints = 0;
  for (const paper::JointSet& set : model.bounds.sets_of(0)) joints += set.joint_count;
  return joints;
}

Result<std::vector<Cell>> subdivision_row(const std::vector<scenes::Character>& dwarves,
                                          std::size_t level, const Position& position,
                                          const Conditions& conditions) {
  const scenes::Character& dwarf = dwarves[level];
  const auto figures =
      measure_scene(facing_pair(dwarf, position.distance), kMethods, 1, conditions);
  if (!figures) return figures.error();
  const auto time = [&](MethodKind method) { return mean_us(*figures, method, Question::all); };
  const auto count = [](std::uint64_t number) { return static_cast<double>(number); };
  std::vector<Cell> row = {count(level), count(dwarf.asset.triangles.size()), sphere_count(dwarf),
                           contact_count(*figures)};
  for (const MethodKind method : kMethods) row.push_back(time(method));
  const QueryStats& work = work_of(*figures, methods::kPaper);
  for (const double figure :
       {count(work.refits), joints_of_root(dwarf), count(work.node_pairs),
        count(work_of(*figures, lab::kPaperEager).node_pairs),
        time(lab::kPaperEager) / time(methods::kPaper), position.speed_ups[level],
        time(methods::kEager) / time(methods::kOnDemand)})
    row.push_back(figure);
  return row;
}

Result<Table> position_table(const std::vector<scenes::Character>& dwarves,
                             const Position& position, const Conditions& conditions) {
  Table table = empty_table(position);
  for (std::size_t level = 0; level < dwarves.size(); ++level) {
    auto row = subdivision_row(dwarves, level, position, conditions);
    if (!row) return row.error();
    table.rows.push_back(std::move(*row));
  }
  return table;
}

/// Table 3 as printed in the paper.
Table printed_table(std::size_t levels) {
  Table table = {"dwarves_printed",
                 "The interfering dwarves in the paper (Table 3)",
                 {{"subdivisions", "subdivisions"},
                  {"spheres", "spheres"},
                  {"contacts", "collisions"},
                  {"on_demand_ms", "on demand [ms]"},
                  {"on_demand_sphere_pairs", "its sphere tests"},
                  {"bottom_up_ms", "bottom-up [ms]"},
                  {"bottom_up_sphere_pairs", "its sphere tests"},
                  {"speed_up", "speed-up"}},
                 {},
                 ""};
  for (std::size_t level = 0; level < levels; ++level)
    table.rows.push_back({static_cast<double>(level), kPaperDwarvesSpheres[level],
                          kPaperDwarvesContacts[level], kPaperDwarvesOnDemand[level],
                          kPaperDwarvesOnDemandPairs[level], kPaperDwarvesBottomUp[level],
                          kPaperDwarvesBottomUpPairs[level], kPaperDwarvesSpeedUps[level]});
  return table;
}

Table drift_table(const std::vector<scenes::Character>& dwarves) {
  Table table = {
      "drift",
      "Drift of posed vertices under subdivision",
      {{"subdivisions", "subdivisions"}, {"drift_percent", "drift [% of the height]"}},
      {},
      "For the interfering pose: the largest distance of a new vertex from the middle "
      "of its edge, summed over the subdivisions. No vertex is farther than this from the "
      "first mesh."};
  double drifted = 0;
  for (std::size_t level = 0; level < dwarves.size(); ++level) {
    drifted = drift(dwarves, level, drifted);
    table.rows.push_back({static_cast<double>(level), drifted});
  }
  return table;
}

/// The time to build both sphere trees over the posed dwarves.
Result<double> rigid_build_us(const scenes::Scene& scene) {
  const auto colliders =
      tools::scene::make_colliders(scene, tools::scene::Granularity::instance, {});
  if (!colliders) return colliders.error();
  tools::scene::SceneQuery query(*colliders, lab::kPaperRigid.make());
  asset::SampleScratch scratch;
  tools::scene::Palettes palettes;
  tools::scene::sample_palettes(scene, 0, scratch, palettes);
  std::vector<double> times;
  for (int repetition = 0; repetition < 5; ++repetition) {
    tools::bench::Stopwatch watch;
    if (const auto set = query.set_palettes(palettes); !set) return set.error();
    watch.stop();
    times.push_back(watch.microseconds());
  }
  return tools::output::median(times);
}

/// "On the posture from Figure 7 right we performed also a comparison with rigid body CD."
Result<Table> rigid_table(const scenes::Character& dwarf, const Conditions& conditions) {
  const scenes::Scene scene = facing_pair(dwarf, kInterfering);
  constexpr std::array kRigid = {methods::kPaper, lab::kPaperRigid, methods::kOnDemand,
                                 lab::kRigid};
  const auto figures = measure_scene(scene, kRigid, 1, conditions);
  if (!figures) return figures.error();
  const auto build = rigid_build_us(scene);
  if (!build) return build.error();
  const auto time = [&](MethodKind method) { return mean_us(*figures, method, Question::all); };
  const double paper_ratio = time(methods::kPaper) / time(lab::kPaperRigid);
  return Table{
      "rigid",
      "The interfering dwarves as rigid bodies, without subdivision",
      {{"what", "what"}, {"here_us", "here [us]"}, {"printed_us", "in the paper [us]"}},
      {{"paper on demand, refits included", time(methods::kPaper), 1000 * kPaperDwarvesOnDemand[0]},
       {"paper rigid: sphere trees built over the pose", time(lab::kPaperRigid),
        1000 * kPaperRigidQuery},
       {"building them", *build, 1000 * kPaperRigidBuild},
       {"the first over the second, times", paper_ratio,
        kPaperDwarvesOnDemand[0] / kPaperRigidQuery},
       {"Pelt", time(methods::kOnDemand), Cell()},
       {"Pelt rigid", time(lab::kRigid), Cell()},
       {"Pelt over Pelt rigid, times", time(methods::kOnDemand) / time(lab::kRigid), Cell()}},
      ""};
}

Chart chart_of(const Table& table) {
  return {table.id + "_time",
          table.title,
          table.id,
          "triangles",
          {"paper_us", "paper_eager_us", "eager_us", "on_demand_us"},
          "a query [us]",
          Axes::logarithmic,
          Better::lower};
}

std::string text_of(const Table& table, const char* where) {
  const auto figure = [&](std::size_t row, const char* key) {
    return shown(table.rows[row][column_of(table, key)]);
  };
  const std::size_t last = table.rows.size() - 1;
  return std::string(where) + ", refit on demand is " + figure(0, "paper_speed_up") + " to " +
         figure(last, "paper_speed_up") + " times as fast as bottom-up (" +
         figure(0, "printed_speed_up") + " to " + figure(last, "printed_speed_up") +
         " in the paper): its time grows from " + figure(0, "paper_us") + " to " +
         figure(last, "paper_us") + " us, although it needs " + figure(0, "paper_refits") +
         " and " + figure(last, "paper_refits") + " refits. Pelt is " + figure(0, "speed_up") +
         " to " + figure(last, "speed_up") + " times as fast as Pelt eager, and takes " +
         figure(0, "on_demand_us") + " to " + figure(last, "on_demand_us") + " us.";
}

/// Why refits of finer dwarves cost more here, unlike in the paper.
std::string text_of_joints(const Table& table) {
  const auto joints = [&](std::size_t row) {
    return shown(table.rows[row][column_of(table, "paper_joints")]);
  };
  return "A new vertex follows the joints of both ends of its edge, so large spheres gain joint "
         "sets. The time of a refit is proportional to the number of joints in these sets, not to "
         "the number of vertices: the root has " +
         joints(0) + " before and " + joints(table.rows.size() - 1) +
         " after the last subdivision. This is why finer dwarves that are apart take longer with "
         "fewer refits.";
}

std::string text_of_drift(const Table& table) {
  return "Each triangle is cut into four at the middles of its edges. A new vertex has the mean of "
         "the weights of its edge's ends, and all of their joints. Posed, it is near the middle of "
         "the posed edge, at most " +
         shown(table.rows.back()[column_of(table, "drift_percent")]) +
         " % of the height from the shape of the first mesh.";
}

}  // namespace

Result<Section> subdivision(const Conditions& conditions) {
  const auto dwarves = subdivisions(conditions.is_quick ? 2 : 3);
  if (!dwarves) return dwarves.error();
  const Position apart = {"dwarves_apart", "Dwarves apart (Figure 7, left)", kApart,
                          kPaperApartSpeedUps};
  const Position interfering = {"dwarves_interfering",
                                "Intersecting dwarves (Table 3, Figure 7, right)", kInterfering,
                                kPaperDwarvesSpeedUps};
  Section section;
  for (const Position& position : {apart, interfering}) {
    auto table = position_table(*dwarves, position, conditions);
    if (!table) return table.error();
    section.charts.push_back(chart_of(*table));
    section.tables.push_back(std::move(*table));
  }
  auto picture = dwarves_picture(facing_pair(dwarves->front(), kApart),
                                 facing_pair(dwarves->front(), kInterfering),
                                 facing_pair((*dwarves)[2], kInterfering), conditions);
  if (!picture) return picture.error();
  section.pictures.push_back(std::move(*picture));
  auto rigid = rigid_table(dwarves->front(), conditions);
  if (!rigid) return rigid.error();
  const Table drift = drift_table(*dwarves);
  section.text = {text_of(section.tables[0], "Apart"), text_of(section.tables[1], "Intersecting"),
                  text_of_joints(section.tables[0]), text_of_drift(drift)};
  section.tables.push_back(printed_table(dwarves->size()));
  section.tables.push_back(std::move(*rigid));
  section.tables.push_back(drift);
  return section;
}

}  // namespace pelt::reproduce

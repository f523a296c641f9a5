/// Table 3 and Figure 7 of the paper: two dwarves whose triangles are cut into four again and
/// again, apart and in each other.

#include "bench/method.hpp"
#include "bench/statistics.hpp"
#include "paper/sphere_tree.hpp"
#include "tools/pelt/scene_query.hpp"
#include "tools/pelt/stopwatch.hpp"
#include "tools/reproduce/facing_pair.hpp"
#include "tools/reproduce/figures.hpp"
#include "tools/reproduce/paper_figures.hpp"
#include "tools/reproduce/scene_figures.hpp"
#include "tools/reproduce/subdivide.hpp"

namespace pelt::reproduce {
namespace {

using bench::MethodKind;
using tools::Question;

/// How far the two stand from each other: bounds overlap, and hands meet.
constexpr double kApart = 0.85, kInterfering = 0.73;

constexpr std::array kMethods = {MethodKind::paper, MethodKind::paper_eager, MethodKind::eager,
                                 MethodKind::on_demand};

/// The dwarf and what its triangles are cut into.
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

/// Of all levels so far, in millionths of the character's height.
double drift(const std::vector<scenes::Character>& dwarves, std::size_t level, double before) {
  if (level == 0) return 0;
  const scenes::Scene scene = facing_pair(dwarves[0], kInterfering);
  asset::SampleScratch scratch;
  std::vector<Matrix4> palette(dwarves[0].asset.joints.size());
  scenes::instance_palette(scene, 0, 0, scratch, palette);
  constexpr double kHeight = 1.8;
  return before + 1e6 / kHeight * drift_of(dwarves[level - 1].asset, dwarves[level].asset, palette);
}

double sphere_count(const scenes::Character& dwarf) {
  const asset::Asset& asset = dwarf.asset;
  return static_cast<double>(
      paper::build_sphere_tree(asset.rest_positions, asset.triangles).nodes.size());
}

double node_pairs_of(const tools::SceneFigures& figures, MethodKind method) {
  const tools::Figures& of = figures_of(figures, bench::name_of(method), Question::all);
  return static_cast<double>(of.answer.work.node_pairs);
}

Table empty_table(const char* id, const char* title, bool is_interfering) {
  Table table = {id,
                 title,
                 {{"subdivisions", "subdivisions"},
                  {"triangles", "triangles"},
                  {"spheres", "spheres"},
                  {"contacts", "contacts"},
                  {"paper_us", "paper [us]"},
                  {"paper_sphere_pairs", "its sphere tests"},
                  {"paper_eager_us", "bottom-up [us]"},
                  {"paper_eager_sphere_pairs", "its sphere tests"},
                  {"eager_us", "our eager [us]"},
                  {"on_demand_us", "Pelt [us]"},
                  {"paper_speed_up", "paper over bottom-up"},
                  {"speed_up", "Pelt over our eager"},
                  {"printed_speed_up", "paper over bottom-up, as printed"},
                  {"drift_ppm", "drift [height / 1e6]"}},
                 {},
                 "Drift: how far posed vertices have left the first mesh at most, summed over the "
                 "subdivisions."};
  if (is_interfering) {
    table.columns.push_back({"printed_contacts", "contacts, as printed"});
    table.columns.push_back({"printed_sphere_pairs", "sphere tests, as printed"});
  }
  return table;
}

/// What the paper prints of a position of the two.
struct Position {
  const char *id, *title;
  double distance;
  std::span<const double> speed_ups, contacts, sphere_pairs;  // by level
};

Result<std::vector<Cell>> subdivision_row(const scenes::Character& dwarf, const Position& position,
                                          const Conditions& conditions) {
  const scenes::Scene scene = facing_pair(dwarf, position.distance);
  const auto figures = measure_scene(scene, kMethods, 1, conditions);
  if (!figures) return figures.error();
  const auto time = [&](MethodKind method) { return mean_us(*figures, method, Question::all); };
  return std::vector<Cell>{static_cast<double>(dwarf.asset.triangles.size()),
                           sphere_count(dwarf),
                           contact_count(*figures),
                           time(MethodKind::paper),
                           node_pairs_of(*figures, MethodKind::paper),
                           time(MethodKind::paper_eager),
                           node_pairs_of(*figures, MethodKind::paper_eager),
                           time(MethodKind::eager),
                           time(MethodKind::on_demand),
                           time(MethodKind::paper_eager) / time(MethodKind::paper),
                           time(MethodKind::eager) / time(MethodKind::on_demand)};
}

Result<Table> position_table(const std::vector<scenes::Character>& dwarves,
                             const Position& position, const Conditions& conditions) {
  Table table = empty_table(position.id, position.title, !position.contacts.empty());
  double drifted = 0;
  for (std::size_t level = 0; level < dwarves.size(); ++level) {
    auto row = subdivision_row(dwarves[level], position, conditions);
    if (!row) return row.error();
    row->insert(row->begin(), static_cast<double>(level));
    row->push_back(position.speed_ups[level]);
    drifted = drift(dwarves, level, drifted);
    row->push_back(drifted);
    if (!position.contacts.empty()) {
      row->push_back(position.contacts[level]);
      row->push_back(position.sphere_pairs[level]);
    }
    table.rows.push_back(std::move(*row));
  }
  return table;
}

/// Both build times of sphere trees over the posed dwarves.
Result<double> rigid_build_us(const scenes::Scene& scene) {
  const auto colliders = tools::make_colliders(scene, tools::Granularity::instance, {});
  if (!colliders) return colliders.error();
  tools::SceneQuery query(*colliders, bench::make_method(MethodKind::paper_rigid));
  asset::SampleScratch scratch;
  tools::Palettes palettes;
  tools::sample_palettes(scene, 0, scratch, palettes);
  std::vector<double> times;
  for (int repetition = 0; repetition < 5; ++repetition) {
    tools::Stopwatch watch;
    if (const auto set = query.set_palettes(palettes); !set) return set.error();
    watch.stop();
    times.push_back(watch.microseconds());
  }
  return bench::median(times);
}

/// "On the posture from Figure 7 right we performed also a comparison with rigid body CD."
Result<Table> rigid_table(const scenes::Character& dwarf, const Conditions& conditions) {
  const scenes::Scene scene = facing_pair(dwarf, kInterfering);
  constexpr std::array kRigid = {MethodKind::paper, MethodKind::paper_rigid, MethodKind::on_demand,
                                 MethodKind::rigid};
  const auto figures = measure_scene(scene, kRigid, 1, conditions);
  if (!figures) return figures.error();
  const auto build = rigid_build_us(scene);
  if (!build) return build.error();
  const auto time = [&](MethodKind method) { return mean_us(*figures, method, Question::all); };
  return Table{"rigid",
               "The interfering dwarves as rigid bodies, without subdivision",
               {{"what", "what"}, {"here_us", "here [us]"}, {"printed_us", "as printed [us]"}},
               {{"the paper's query, refits on demand included", time(MethodKind::paper),
                 1000 * kPaperDwarvesOnDemand[0]},
                {"the query of sphere trees built over the pose", time(MethodKind::paper_rigid),
                 1000 * kPaperRigidQuery},
                {"building them", *build, 1000 * kPaperRigidBuild},
                {"Pelt's query on demand", time(MethodKind::on_demand), Cell()},
                {"Pelt's query of rigid bodies", time(MethodKind::rigid), Cell()}},
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

}  // namespace

Result<Section> subdivision(const Conditions& conditions) {
  const auto dwarves = subdivisions(conditions.is_quick ? 2 : 3);
  if (!dwarves) return dwarves.error();
  const Position apart = {
      "dwarves_apart", "Dwarves apart (Figure 7, left)", kApart, kPaperApartSpeedUps, {}, {}};
  const Position interfering = {
      "dwarves_interfering", "Dwarves in each other (Table 3, Figure 7, right)",
      kInterfering,          kPaperDwarvesSpeedUps,
      kPaperDwarvesContacts, kPaperDwarvesSpherePairs};
  Section section;
  for (const Position& position : {apart, interfering}) {
    auto table = position_table(*dwarves, position, conditions);
    if (!table) return table.error();
    section.charts.push_back(chart_of(*table));
    section.tables.push_back(std::move(*table));
  }
  auto picture = dwarves_picture(facing_pair(dwarves->front(), kApart),
                                 facing_pair(dwarves->front(), kInterfering), conditions);
  if (!picture) return picture.error();
  section.pictures.push_back(std::move(*picture));
  auto rigid = rigid_table(dwarves->front(), conditions);
  if (!rigid) return rigid.error();
  section.tables.push_back(std::move(*rigid));
  section.text = {
      "Each triangle is cut into four at the middles of its edges. A new vertex has the mean of "
      "the "
      "weights of its edge's ends, as many joints as these have together."};
  return section;
}

}  // namespace pelt::reproduce

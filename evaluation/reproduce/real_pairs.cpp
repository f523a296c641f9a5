/// Pairs of intersecting real characters, so that the conclusions do not depend on generated ones
/// alone.

#include "evaluation/reproduce/experiment.hpp"
#include "evaluation/reproduce/method_title.hpp"
#include "evaluation/reproduce/real_models.hpp"
#include "evaluation/reproduce/scene_figures.hpp"
#include "evaluation/reproduce/specimen.hpp"
#include "skin/skin.hpp"

#include <algorithm>

namespace pelt::reproduce {
namespace {

using methods::MethodKind;
using tools::bench::Question;

constexpr std::array kMethods = {methods::kPaper, lab::kPaperEager, methods::kEager,
                                 methods::kOnDemand};

/// Distance of the second character in widths of the first.
constexpr double kWidths = 0.6;

/// The width of the character along x in its default pose.
Result<double> width_of(const scenes::Scene& scene) {
  const Result<Specimen> specimen = make_specimen(scene.characters[0].asset);
  if (!specimen) return specimen.error();
  std::vector<Matrix4> joints(specimen->asset.joints.size());
  asset::SampleScratch scratch;
  scenes::instance_palette(scene, 0, 0, scratch, joints);
  detail::Palette palette(specimen->mesh.joint_count, specimen->mesh.rest_extent);
  if (const auto taken = palette.set(joints); !taken) return taken.error();
  std::vector<Vec3> posed(specimen->mesh.vertex_count());
  detail::posed_vertices(specimen->mesh, palette, posed);
  const auto [least, most] = std::minmax_element(
      posed.begin(), posed.end(), [](const Vec3& a, const Vec3& b) { return a.x < b.x; });
  return static_cast<double>(most->x) - static_cast<double>(least->x);
}

/// Two instances of a character that play its first clip, half a second apart.
Result<scenes::Scene> pair_of(const scenes::Character& character) {
  scenes::Scene scene;
  scene.name = "two of " + character.name;
  scene.characters = {character};
  scene.frame_count = 60;
  scenes::Instance one;
  if (!character.asset.clips.empty()) one.clip = character.asset.clips.front().name;
  scene.instances = {one, one};
  const Result<double> width = width_of(scene);
  if (!width) return width.error();
  scene.instances[1].start = 0.5;
  scene.instances[1].translation = {kWidths * *width, 0, 0};
  return scene;
}

Result<std::vector<Cell>> row_of(const scenes::Character& character, const Conditions& conditions) {
  const auto scene = pair_of(character);
  if (!scene) return scene.error();
  const auto figures = measure_scene(*scene, kMethods, 12, conditions);
  if (!figures) return figures.error();
  std::vector<Cell> row = {character.name, static_cast<double>(character.asset.triangles.size()),
                           static_cast<double>(character.asset.joints.size()),
                           contact_count(*figures)};
  const auto time = [&](MethodKind method) { return mean_us(*figures, method, Question::all); };
  for (const MethodKind method : kMethods) row.push_back(time(method));
  row.push_back(time(lab::kPaperEager) / time(methods::kPaper));
  row.push_back(time(methods::kEager) / time(methods::kOnDemand));
  return row;
}

Table empty_table() {
  Table table = {
      "real_pairs",
      "Two intersecting instances of each real character",
      {{"character", "character"},
       {"triangles", "triangles"},
       {"joints", "joints"},
       {"contacts", "contacts per frame"}},
      {},
      "The second instance is 0.6 widths beside the first; both play the first clip, half a "
      "second apart. All contacts, at most 12 frames over two seconds, means over the "
      "frames."};
  for (const MethodKind method : kMethods)
    table.columns.push_back({std::string(method.name) + "_us", title_of(method) + " [us]"});
  table.columns.push_back({"paper_speed_up", "speed-up, paper on demand against bottom-up"});
  table.columns.push_back({"speed_up", "speed-up, Pelt against Pelt eager"});
  return table;
}

/// The range of a column: "1.2 to 9.9".
std::string range(const Table& table, const char* key) {
  const std::size_t column = column_of(table, key);
  double least = *table.rows[0][column].figure, most = least;
  for (const std::vector<Cell>& row : table.rows) {
    least = std::min(least, *row[column].figure);
    most = std::max(most, *row[column].figure);
  }
  return shown(least) + " to " + shown(most);
}

}  // namespace

Result<Section> real_pairs(const Conditions& conditions) {
  Section section;
  if (conditions.models.empty()) {
    section.text = {"No real characters: --models was not given."};
    return section;
  }
  Table table = empty_table();
  std::vector<std::filesystem::path> files = model_files(conditions.models);
  if (conditions.is_quick && files.size() > 4) files.resize(4);
  std::vector<std::string> left_out;
  for (const std::filesystem::path& file : files) {
    const Result<scenes::Character> character = scenes::load_character(file);
    auto row = character ? row_of(*character, conditions) : character.error();
    if (row)
      table.rows.push_back(std::move(*row));
    else
      left_out.push_back("Left out: " + file.filename().string() + ", which Pelt does not accept.");
  }
  if (!table.rows.empty()) {
    section.text = {"For these pairs, refitting on demand with the paper's method is " +
                    range(table, "paper_speed_up") + " times as fast as bottom-up, and Pelt is " +
                    range(table, "speed_up") + " times as fast as Pelt eager."};
    section.tables = {std::move(table)};
  }
  section.text.insert(section.text.end(), left_out.begin(), left_out.end());
  return section;
}

}  // namespace pelt::reproduce

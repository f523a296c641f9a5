/// The characters of the experiments. Table 1 of the paper: sizes of its characters and of ours.
/// Pairs of intersecting real characters.

#include "evaluation/reproduce/characters.hpp"

#include "base/assert.hpp"
#include "evaluation/reproduce/paper_figures.hpp"
#include "evaluation/reproduce/report.hpp"
#include "evaluation/reproduce/scene_figures.hpp"
#include "model/model.hpp"
#include "model/unpack.hpp"
#include "scenes/scene.hpp"
#include "skin/skin.hpp"

#include <algorithm>
#include <system_error>

namespace pelt::reproduce {

using methods::MethodKind;
using tools::bench::Question;

Result<Specimen> make_specimen(asset::Asset asset) {
  const Result<SkinnedModel> model = build_model(asset.mesh());
  if (!model) return model.error();
  detail::SkinnedMesh mesh = detail::unpack_mesh(model->detail().tree);
  return Specimen{std::move(asset), *model, std::move(mesh)};
}

Result<Specimen> make_specimen(const scenes::CreatureOptions& options) {
  Result<asset::Asset> asset = scenes::make_creature(options);
  if (!asset) return asset.error();
  return make_specimen(std::move(*asset));
}

detail::Palette walking_palette(const Specimen& specimen, float seconds) {
  const asset::Asset& asset = specimen.asset;
  std::vector<Matrix4> joints(asset.joints.size());
  asset::SampleScratch scratch;
  asset::sample_palette(asset, asset.find_clip("walk"), seconds, {}, scratch, joints);
  detail::Palette palette(specimen.mesh.joint_count, specimen.mesh.rest_extent);
  const Result<void> taken = palette.set(joints);
  PELT_ASSERT(taken);
  return palette;
}

std::vector<std::filesystem::path> model_files(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error))
    if (entry.path().extension() == ".glb") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

namespace {

Table empty_table() {
  return {"characters",
          "Characters (Table 1)",
          {{"character", "character"},
           {"vertices", "vertices"},
           {"triangles", "triangles"},
           {"joints", "joints"},
           {"paper_vertices", "vertices in the paper"},
           {"paper_triangles", "triangles in the paper"},
           {"paper_joints", "joints in the paper"}},
          {},
          ""};
}

std::vector<Cell> row(const std::string& name, const asset::Asset& asset) {
  return {name, static_cast<double>(asset.rest_positions.size()),
          static_cast<double>(asset.triangles.size()), static_cast<double>(asset.joints.size())};
}

Result<void> add_generated(Table& table) {
  for (const PaperCharacter& of : kPaperCharacters) {
    const Result<asset::Asset> asset = scenes::make_creature(of.options);
    if (!asset) return asset.error();
    std::vector<Cell> cells = row(std::string("generated ") + of.name, *asset);
    for (const double figure : {of.vertices, of.triangles, of.joints}) cells.push_back(figure);
    table.rows.push_back(std::move(cells));
  }
  return {};
}

void add_real(const std::filesystem::path& folder, Section& section) {
  Table& table = section.tables[0];
  for (const std::filesystem::path& file : model_files(folder)) {
    const Result<scenes::Character> character = scenes::load_character(file);
    if (!character) {
      section.text.push_back("Left out: " + file.filename().string() +
                             ", which Pelt does not accept.");
      continue;
    }
    table.rows.push_back(row(file.filename().string(), character->asset));
    table.rows.back().resize(table.columns.size());
  }
}

}  // namespace

Result<Section> characters(const Conditions& conditions) {
  Section section;
  section.tables.push_back(empty_table());
  if (const auto added = add_generated(section.tables[0]); !added) return added.error();
  section.text.push_back(
      "The paper's characters are not available. Pelt generates walking bipeds with the same "
      "numbers of triangles and joints.");
  if (conditions.models.empty())
    section.text.push_back("No real characters: --models was not given.");
  else
    add_real(conditions.models, section);
  return section;
}

namespace {

// Pairs of intersecting real characters, so that the conclusions do not depend on generated ones
// alone.

constexpr std::array kOnRealPairs = {methods::kPaper, lab::kPaperEager, methods::kEager,
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
  const auto figures = measure_scene(*scene, kOnRealPairs, 12, conditions);
  if (!figures) return figures.error();
  std::vector<Cell> row = {character.name, static_cast<double>(character.asset.triangles.size()),
                           static_cast<double>(character.asset.joints.size()),
                           contact_count(*figures)};
  const auto time = [&](MethodKind method) { return mean_us(*figures, method, Question::all); };
  for (const MethodKind method : kOnRealPairs) row.push_back(time(method));
  row.push_back(time(lab::kPaperEager) / time(methods::kPaper));
  row.push_back(time(methods::kEager) / time(methods::kOnDemand));
  return row;
}

Table pairs_table() {
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
  for (const MethodKind method : kOnRealPairs)
    table.columns.push_back({std::string(method.name) + "_us", title_of(method) + " [us]"});
  table.columns.push_back({"paper_speed_up", "speed-up, paper on demand against bottom-up"});
  table.columns.push_back({"speed_up", "speed-up, Pelt against Pelt eager"});
  return table;
}

}  // namespace

Result<Section> real_pairs(const Conditions& conditions) {
  Section section;
  if (conditions.models.empty()) {
    section.text = {"No real characters: --models was not given."};
    return section;
  }
  Table table = pairs_table();
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
                    range_of(table, "paper_speed_up") +
                    " times as fast as bottom-up, and Pelt is " + range_of(table, "speed_up") +
                    " times as fast as Pelt eager."};
    section.tables = {std::move(table)};
  }
  section.text.insert(section.text.end(), left_out.begin(), left_out.end());
  return section;
}

}  // namespace pelt::reproduce

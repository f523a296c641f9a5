/// Table 1 of the paper: sizes of the characters.

#include "evaluation/reproduce/experiment.hpp"
#include "evaluation/reproduce/paper_figures.hpp"
#include "evaluation/reproduce/real_models.hpp"
#include "scenes/scene.hpp"

namespace pelt::reproduce {
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

}  // namespace pelt::reproduce

#include "scenes/excluded_nodes.hpp"

#include <gtest/gtest.h>

namespace pelt::scenes {
namespace {

using Names = std::vector<std::string>;

/// A file with one mesh node; if `part` is empty, the mesh has no name.
Character file(const std::string& name, const std::string& node, const std::string& part) {
  Character character;
  character.name = name;
  character.asset.nodes.resize(1);
  character.asset.nodes[0].name = node;
  character.asset.parts.resize(1);
  character.asset.parts[0].node = part;
  return character;
}

Scene knight_and_thief() {
  Scene scene;
  scene.characters.push_back(file("knight", "Cape", "Body"));
  scene.characters.push_back(file("thief", "Hood", "Body"));
  return scene;
}

asset::GltfOptions excluding(const Names& names) {
  asset::GltfOptions options;
  options.exclude_nodes = names;
  return options;
}

std::string refusal(const Scene& scene, const Names& names) {
  const Result<void> checked = check_excluded(scene, excluding(names));
  return checked ? "" : checked.error().message;
}

TEST(ExcludedNodes, AreOfAllModelsOrOfTheOneThatTheirNamesBeginWith) {
  const asset::GltfOptions all = excluding({"Cape", "knight/Belt", "thief/Belt"});
  const asset::GltfOptions knight = options_for("knight", all);
  EXPECT_EQ(knight.exclude_nodes, (Names{"Cape", "Belt", "thief/Belt"}));
  EXPECT_FALSE(knight.excluded_must_exist);
}

TEST(ExcludedNodes, NeedToBeInOneModelOnly) {
  EXPECT_EQ(refusal(knight_and_thief(), {"Cape", "Hood", "thief/Hood"}), "");
}

TEST(ExcludedNodes, AreRefusedWhereNoFileHasThem) {
  EXPECT_EQ(refusal(knight_and_thief(), {"Cape", "Bdoy"}),
            "no node to exclude is named \"Bdoy\", did you mean \"Body\"?");
  EXPECT_EQ(refusal(knight_and_thief(), {"thief/Cape"}),
            "no node to exclude is named \"thief/Cape\", expected one of \"knight/Body\", "
            "\"thief/Body\"");
}

TEST(ExcludedNodes, AreNotOfGeneratedCharacters) {
  Scene scene = knight_and_thief();
  scene.characters[0].origin = CreatureOptions();
  EXPECT_EQ(refusal(scene, {"Cape"}),
            "no node to exclude is named \"Cape\", expected one of \"Body\"");
  scene.characters[1].origin = CreatureOptions();
  EXPECT_EQ(
      refusal(scene, {"Hood"}),
      "no node to exclude is named \"Hood\": the characters of the scene do not come from files, "
      "exclude nothing");
}

}  // namespace
}  // namespace pelt::scenes

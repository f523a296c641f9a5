#include "scenes/ignored_pairs.hpp"

#include "model/surface.hpp"
#include "scenes/creature.hpp"
#include "scenes/excluded_nodes.hpp"
#include "scenes/name_index.hpp"
#include "scenes/triangle_labels.hpp"
#include "support/random.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <set>

namespace pelt::scenes {
namespace {

/// Four triangles: "body" has two that follow "hips" and one that follows "arm"; "cape" has one
/// that follows "spine".
Character person(const std::string& name) {
  Character character;
  character.name = character.source = name;
  asset::Asset& asset = character.asset;
  asset.rest_positions.resize(12, Vec3{0, 0, 0});
  asset.triangles = {{0, 1, 2}, {3, 4, 5}, {6, 7, 8}, {9, 10, 11}};
  asset.joint_indices = {0, 0, 0, 0, 0, 0, 1, 1, 1, 2, 2, 2};
  asset.weights.assign(12, 1);
  asset.joints.resize(3);
  asset.nodes.resize(3);
  for (std::uint32_t j = 0; j < 3; ++j) asset.joints[j].node = j;
  asset.nodes[0].name = "hips";
  asset.nodes[1].name = "arm";
  asset.nodes[2].name = "spine";
  asset.parts.resize(2);
  asset.parts[0] = {"body", "", "", 0, 3, true};
  asset.parts[1] = {"cape", "", "", 3, 1, true};
  return character;
}

class IgnoredPairsOfTwo : public ::testing::Test {
 protected:
  IgnoredPairs make(const std::vector<NamePair>& pairs) {
    EXPECT_TRUE(check_names(characters_, pairs));
    const auto ignored = IgnoredPairs::make(characters_, pairs);
    EXPECT_TRUE(ignored) << ignored.error().message;
    return *ignored;
  }

  std::string refusal(const std::string& name) {
    const std::vector<NamePair> pairs = {{"cape", name}};
    const Result<void> checked = check_names(characters_, pairs);
    return checked ? "" : checked.error().message;
  }

 private:
  Character knight_ = person("knight"), thief_ = person("thief");
  std::vector<const Character*> characters_ = {&knight_, &thief_};
};

TEST_F(IgnoredPairsOfTwo, AreNoneWithoutNames) {
  EXPECT_TRUE(make({}).is_empty());
  EXPECT_FALSE(make({}).is_ignored(0, 0, 1, 0));
}

TEST_F(IgnoredPairsOfTwo, MeanPartsAndJointsInEitherOrder) {
  const IgnoredPairs ignored = make({{"cape", "arm"}});
  EXPECT_FALSE(ignored.is_empty());
  EXPECT_TRUE(ignored.is_ignored(0, 3, 1, 2));
  EXPECT_TRUE(ignored.is_ignored(0, 2, 1, 3));
  EXPECT_TRUE(ignored.is_ignored(1, 2, 1, 3));
  EXPECT_FALSE(ignored.is_ignored(0, 3, 1, 3));
  EXPECT_FALSE(ignored.is_ignored(0, 2, 1, 2));
  EXPECT_FALSE(ignored.is_ignored(0, 3, 1, 0));
}

TEST_F(IgnoredPairsOfTwo, AreConfinedToAModelByItsName) {
  const IgnoredPairs ignored = make({{"knight/cape", "arm"}});
  EXPECT_TRUE(ignored.is_ignored(0, 3, 1, 2));
  EXPECT_TRUE(ignored.is_ignored(1, 2, 0, 3));
  EXPECT_FALSE(ignored.is_ignored(1, 3, 0, 2));
}

TEST_F(IgnoredPairsOfTwo, LeaveTheOtherContactsInTheirOrder) {
  std::vector<Contact> contacts = {{0, 0}, {3, 2}, {1, 3}, {2, 3}, {3, 3}};
  ASSERT_EQ(make({{"cape", "arm"}}).keep_counted(0, 1, contacts), 3u);
  contacts.resize(3);
  EXPECT_EQ(contacts, (std::vector<Contact>{{0, 0}, {1, 3}, {3, 3}}));
}

TEST_F(IgnoredPairsOfTwo, MeanBodiesOnlyWhereOneRuleMeansAllOfThem) {
  using Body = IgnoredPairs::Body;
  const Body knight = {0, 0, 4}, thief = {1, 0, 4}, cape = {0, 3, 1};
  EXPECT_TRUE(make({{"thief/*", "knight/*"}}).are_ignored(knight, thief));
  EXPECT_TRUE(make({{"cape", "thief/*"}}).are_ignored(cape, thief));
  EXPECT_TRUE(make({{"cape", "thief/*"}}).are_ignored(thief, cape));
  EXPECT_FALSE(make({{"cape", "thief/*"}}).are_ignored(knight, thief));
  EXPECT_FALSE(make({{"body", "thief/*"}, {"cape", "thief/*"}}).are_ignored(knight, thief));
  EXPECT_FALSE(make({{"cape", "thief/body"}}).are_ignored(cape, thief));
}

TEST_F(IgnoredPairsOfTwo, RefuseNamesThatNothingHas) {
  EXPECT_EQ(refusal("kape"), R"(no part and no joint is named "kape", did you mean "cape"?)");
  EXPECT_EQ(refusal("knigth/hips"),
            R"(no part and no joint is named "knigth/hips", did you mean "knight/hips"?)");
  EXPECT_EQ(refusal("*wing*"), R"(no part and no joint is named "*wing*", expected one of "body", )"
                               R"("cape", "hips", "arm", "spine")");
  EXPECT_EQ(refusal("thief/*i*"), "");
}

/// Part p has triangle p; all follow one joint.
Character many_parts(std::uint32_t count) {
  Character character;
  character.name = character.source = "crowd";
  asset::Asset& asset = character.asset;
  asset.rest_positions.resize(3, Vec3{0, 0, 0});
  asset.triangles.resize(count, Triangle{0, 1, 2});
  asset.joint_indices = {0, 0, 0};
  asset.weights = {1, 1, 1};
  asset.joints.resize(1);
  asset.nodes.resize(1);
  asset.nodes[0].name = "root";
  for (std::uint32_t p = 0; p < count; ++p)
    asset.parts.push_back({"part " + std::to_string(p), "", "", p, 1, true});
  return character;
}

/// Comparing all parts with all names would take 10^10 steps, which is minutes.
TEST(IgnoredPairsOfMany, AreFoundInTimeLinearInNames) {
  constexpr std::uint32_t kCount = 50'000;
  const Character crowd = many_parts(kCount);
  const std::vector<const Character*> characters = {&crowd, &crowd};
  std::vector<NamePair> pairs;
  for (std::uint32_t p = 0; p < kCount; ++p)
    pairs.push_back({"crowd/part " + std::to_string(p), p % 2 == 0 ? "part 7" : "part 8*"});
  ASSERT_TRUE(check_names(characters, pairs));
  const auto ignored = IgnoredPairs::make(characters, pairs);
  ASSERT_TRUE(ignored);
  std::size_t count = 0;
  for (std::uint32_t p = 0; p < kCount; ++p) count += ignored->is_ignored(0, 7, 1, p);
  // "part 7" is paired with the even parts, and "crowd/part 7" with "part 8*", which matches 5 + 50
  // + 500 odd parts.
  EXPECT_EQ(count, kCount / 2 + 5 + 50 + 500);
  EXPECT_TRUE(ignored->are_ignored({0, 7, 1}, {1, 80, 1}));
  EXPECT_FALSE(ignored->are_ignored({0, 7, 2}, {1, 11, 1}));
}

/// All rules are tried for all triangles.
bool is_ignored_by_rules(const std::vector<NamePair>& pairs, const Character& a,
                         std::uint32_t triangle_a, const Character& b, std::uint32_t triangle_b) {
  const auto is_meant = [](const std::string& pattern, const Character& character,
                           std::uint32_t triangle) {
    const asset::Part& part = character.asset.part_of(triangle);
    const std::uint32_t vertex = character.asset.triangles[triangle][0];
    for (const std::string& name :
         {part.node, character.asset.joint_name(character.asset.joint_indices[vertex])})
      if (matches(pattern, name) || matches(pattern, character.name + "/" + name)) return true;
    return false;
  };
  return std::any_of(pairs.begin(), pairs.end(), [&](const NamePair& pair) {
    return (is_meant(pair.a, a, triangle_a) && is_meant(pair.b, b, triangle_b)) ||
           (is_meant(pair.b, a, triangle_a) && is_meant(pair.a, b, triangle_b));
  });
}

TEST(IgnoredPairsOfMany, AreThoseOfTheRules) {
  const Character knight = person("knight"), thief = person("thief");
  const std::vector<const Character*> characters = {&knight, &thief};
  const char* names[] = {"cape",       "body",  "hips", "*",          "arm*",    "*i*", "knight/*",
                         "thief/cape", "spine", "t*e",  "knight/b*y", "nothing", "c*",  "thief/*s"};
  test::Random random(20261123);
  std::size_t ignored_count = 0, cases = 0;
  for (int round = 0; round < 300; ++round) {
    std::vector<NamePair> pairs(1 + random.index(4));
    for (NamePair& pair : pairs)
      pair = {names[random.index(std::size(names))], names[random.index(std::size(names))]};
    const auto ignored = IgnoredPairs::make(characters, pairs);
    ASSERT_TRUE(ignored);
    for (std::uint32_t i = 0; i < 64; ++i) {
      const std::uint32_t a = i / 32, b = i / 16 % 2, s = i / 4 % 4, t = i % 4;
      const bool expected = is_ignored_by_rules(pairs, *characters[a], s, *characters[b], t);
      EXPECT_EQ(ignored->is_ignored(a, s, b, t), expected);
      ignored_count += expected;
      ++cases;
    }
  }
  EXPECT_GT(ignored_count, cases / 10);
  EXPECT_LT(ignored_count, cases / 10 * 9);
}

/// Comparing all names with each other would take 10^11 steps, which is minutes.
TEST(CheckNames, RefusesAnUnknownNameInTimeLinearInNames) {
  Character crowd;
  crowd.name = "crowd";
  crowd.asset.parts.resize(400'000);
  for (std::size_t p = 0; p < crowd.asset.parts.size(); ++p)
    crowd.asset.parts[p].node = "part number " + std::to_string(p);
  const std::vector<const Character*> characters = {&crowd};
  const std::vector<NamePair> pairs = {{"part number 7", "x"}};
  const Result<void> checked = check_names(characters, pairs);
  ASSERT_FALSE(checked);
  EXPECT_NE(checked.error().message.find("no part and no joint is named \"x\""), std::string::npos)
      << checked.error().message;
}

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

/// One joint has the largest sum without being the largest of any vertex; also two parts.
asset::Asset three_triangles() {
  asset::Asset asset;
  asset.rest_positions.resize(9, Vec3{0, 0, 0});
  asset.triangles = {{0, 1, 2}, {3, 4, 5}, {6, 7, 8}};
  asset.influences_per_vertex = 2;
  for (int v = 0; v < 9; ++v) asset.joint_indices.insert(asset.joint_indices.end(), {0, 1});
  asset.weights = {0.4f, 0.6f, 0.9f, 0.1f, 0.4f, 0.6f, 0,    1,    0,
                   1,    0,    1,    0.5f, 0.5f, 0.5f, 0.5f, 0.5f, 0.5f};
  asset.joints.resize(2);
  asset.parts.resize(2);
  asset.parts[0].triangle_count = 2;
  asset.parts[1] = {"", "", "", 2, 1, true};
  return asset;
}

TEST(TriangleLabels, AreTheJointOfTheGreatestSumAndThePart) {
  const auto labels = label_triangles(three_triangles());
  ASSERT_TRUE(labels) << labels.error().message;
  EXPECT_EQ(labels->joint, (std::vector<std::uint16_t>{0, 1, 0}));
  EXPECT_EQ(labels->part, (std::vector<std::uint32_t>{0, 0, 1}));
}

TEST(TriangleLabels, TakeWeightsThatDoNotSumToOneAndRefuseWhatIsNoWeight) {
  asset::Asset asset = three_triangles();
  for (float& weight : asset.weights) weight *= 3;
  ASSERT_TRUE(label_triangles(asset));
  EXPECT_EQ(label_triangles(asset)->joint, (std::vector<std::uint16_t>{0, 1, 0}));
  asset.weights[3] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_FALSE(label_triangles(asset));
}

TEST(TriangleLabels, NameTheJointsThatContactsNameToo) {
  const Result<asset::Asset> creature = make_creature({.triangles = 2000, .joints = 56, .seed = 3});
  ASSERT_TRUE(creature);
  const Result<SkinnedModel> model = build_model(creature->mesh());
  ASSERT_TRUE(model);
  const auto labels = label_triangles(*creature);
  ASSERT_TRUE(labels);
  EXPECT_EQ(labels->joint, model->surface().detail().joints);
  EXPECT_GT(std::set(labels->joint.begin(), labels->joint.end()).size(), 20u);
}

}  // namespace
}  // namespace pelt::scenes

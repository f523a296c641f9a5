#include "scenes/names.hpp"

#include "scenes/name_index.hpp"

#include <gtest/gtest.h>

namespace pelt::scenes {
namespace {

TEST(PartNames, DistinguishPartsOfOneNode) {
  asset::Asset asset;
  asset.parts.resize(2);
  asset.parts[0].node = "body";
  asset.parts[1].node = "boot";
  EXPECT_EQ(part_names(asset), (std::vector<std::string>{"body", "boot"}));
  asset.parts[1].node = "body";
  asset.parts[1].material = "leather";
  EXPECT_EQ(part_names(asset), (std::vector<std::string>{"body:0", "body:leather"}));
}

TEST(PartNames, AreThoseOfMeshesWhereNodesHaveNone) {
  asset::Asset asset;
  asset.parts.resize(1);
  EXPECT_EQ(part_names(asset), std::vector<std::string>{"part:0"});
  asset.parts[0].mesh = "cape";
  EXPECT_EQ(part_names(asset), std::vector<std::string>{"cape"});
  asset.parts.resize(2);
  EXPECT_EQ(part_names(asset), (std::vector<std::string>{"cape:0", "part:1"}));
}

/// Comparing all nodes with each other would take 10^11 steps, which is minutes.
TEST(PartNames, AreFoundInTimeLinearInParts) {
  asset::Asset asset;
  asset.parts.resize(400'000);
  for (std::size_t p = 0; p < asset.parts.size(); ++p)
    asset.parts[p].node = "node " + std::to_string(p);
  asset.parts.back().node = "node 0";
  const std::vector<std::string> names = part_names(asset);
  ASSERT_EQ(names.size(), asset.parts.size());
  EXPECT_EQ(names[0], "node 0:0");
  EXPECT_EQ(names[1], "node 1");
  EXPECT_EQ(names.back(), "node 0:399999");
}

TEST(JointName, IsItsNumberWhereTheFileHasNone) {
  asset::Asset asset;
  asset.nodes.resize(2);
  asset.joints.resize(2);
  asset.nodes[1].name = "knee";
  asset.joints[1].node = 1;
  EXPECT_EQ(joint_name(asset, 0), "joint 0");
  EXPECT_EQ(joint_name(asset, 1), "knee");
  EXPECT_EQ(joint_names(asset), (std::vector<std::string>{"joint 0", "knee"}));
}

using Numbers = std::vector<std::uint32_t>;

/// Parts "part 0" ..., then joints "hips" and "part 3".
Character character_of(std::uint32_t parts) {
  Character character;
  character.name = "knight";
  for (std::uint32_t p = 0; p < parts; ++p)
    character.asset.parts.push_back({"part " + std::to_string(p), "", "", p, 1, true});
  character.asset.joints.resize(2);
  character.asset.nodes.resize(2);
  character.asset.joints[1].node = 1;
  character.asset.nodes[0].name = "hips";
  character.asset.nodes[1].name = "part 3";
  return character;
}

TEST(NameIndex, NumbersPartsThenJoints) {
  const NameIndex index(character_of(5));
  EXPECT_EQ(index.part_count(), 5u);
  EXPECT_EQ(index.find("part 3"), (Numbers{3, 6}));
  EXPECT_EQ(index.find("knight/part 3"), (Numbers{3, 6}));
  EXPECT_EQ(index.find("hips"), Numbers{5});
  EXPECT_EQ(index.find("*"), (Numbers{0, 1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(index.find("k*t/h*"), Numbers{5});
  EXPECT_EQ(index.find("*2"), Numbers{2});
  EXPECT_EQ(index.find("part"), Numbers{});
  EXPECT_EQ(index.find("thief/hips"), Numbers{});
  EXPECT_EQ(index.find(""), Numbers{});
}

TEST(NameIndex, ComparesOnlyNamesThatStartLikeThePattern) {
  const NameIndex index(character_of(10'000));
  EXPECT_EQ(index.candidates("part 7"), 1u);
  EXPECT_EQ(index.candidates("knight/part 7"), 1u);
  EXPECT_EQ(index.candidates("part 77*"), 1u + 10u + 100u);
  EXPECT_EQ(index.candidates("nothing"), 0u);
  EXPECT_EQ(index.candidates("nothing*"), 0u);
  EXPECT_EQ(index.candidates("*7"), 2u * 10'002u);
}

TEST(NamePattern, AStarStandsForAnyCharacters) {
  EXPECT_TRUE(matches("cape", "cape"));
  EXPECT_FALSE(matches("cape", "capes"));
  EXPECT_FALSE(matches("cape", "cap"));
  EXPECT_TRUE(matches("*", ""));
  EXPECT_TRUE(matches("cape*", "cape"));
  EXPECT_TRUE(matches("*hand*", "left_hand.001"));
  EXPECT_TRUE(matches("a*b*c", "a_b_b_c"));
  EXPECT_FALSE(matches("a*b*c", "a_c_b"));
  EXPECT_TRUE(matches("*aab", "aaaaab"));
  EXPECT_FALSE(matches("", "x"));
  EXPECT_TRUE(matches("", ""));
}

}  // namespace
}  // namespace pelt::scenes

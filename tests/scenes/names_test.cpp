#include "scenes/names.hpp"

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

}  // namespace
}  // namespace pelt::scenes

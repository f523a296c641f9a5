#include "scenes/names.hpp"

#include <gtest/gtest.h>

namespace pelt::scenes {
namespace {

TEST(PartName, TellsPartsOfOneNodeApart) {
  asset::Asset asset;
  asset.parts.resize(2);
  asset.parts[0].node = "body";
  asset.parts[1].node = "boot";
  EXPECT_EQ(part_name(asset, 1), "boot");
  asset.parts[1].node = "body";
  asset.parts[1].material = "leather";
  EXPECT_EQ(part_name(asset, 0), "body:0");
  EXPECT_EQ(part_name(asset, 1), "body:leather");
}

TEST(JointName, IsItsNumberWhereTheFileHasNone) {
  asset::Asset asset;
  asset.nodes.resize(2);
  asset.joints.resize(2);
  asset.nodes[1].name = "knee";
  asset.joints[1].node = 1;
  EXPECT_EQ(joint_name(asset, 0), "joint 0");
  EXPECT_EQ(joint_name(asset, 1), "knee");
}

}  // namespace
}  // namespace pelt::scenes

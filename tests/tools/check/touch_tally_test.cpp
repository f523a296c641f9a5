#include "tools/pelt/check/touch_tally.hpp"

#include <gtest/gtest.h>

namespace pelt::tools::check {
namespace {

/// Three triangles. The first follows joint "arm" most by the sum over its vertices, although no
/// single vertex does; the others follow "leg". The last is a separate part.
asset::Asset three_triangles() {
  asset::Asset asset;
  asset.rest_positions.resize(9, Vec3{0, 0, 0});
  asset.triangles = {{0, 1, 2}, {3, 4, 5}, {6, 7, 8}};
  asset.influences_per_vertex = 2;
  for (int v = 0; v < 9; ++v) asset.joint_indices.insert(asset.joint_indices.end(), {0, 1});
  asset.weights = {0.4f, 0.6f, 0.9f, 0.1f, 0.4f, 0.6f, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1};
  asset.nodes.resize(2);
  asset.nodes[0].name = "arm";
  asset.nodes[1].name = "leg";
  asset.joints.resize(2);
  asset.joints[1].node = 1;
  asset.parts.resize(2);
  asset.parts[0].node = "body";
  asset.parts[0].triangle_count = 2;
  asset.parts[1].node = "boot";
  asset.parts[1].first_triangle = 2;
  asset.parts[1].triangle_count = 1;
  return asset;
}

scenes::Scene two_of(asset::Asset asset) {
  scenes::Scene scene;
  scene.characters.push_back({"man", "man.glb", 0, std::move(asset)});
  scene.instances.resize(2);
  return scene;
}

TEST(TouchTally, CountsByDominantJointAndPart) {
  const scenes::Scene scene = two_of(three_triangles());
  const auto colliders = scene::make_colliders(scene, scene::Granularity::instance, {});
  ASSERT_TRUE(colliders) << colliders.error().message;
  scene::FrameContacts found;
  found.contacts = {{0, 0}, {0, 2}, {1, 2}, {2, 1}};
  found.pairs = {{0, 1, 0, 4}};
  Result<TouchTally> tally = TouchTally::make({scene, *colliders});
  ASSERT_TRUE(tally) << tally.error().message;
  tally->add(0, found);

  const std::vector<TouchTally::Row> joints = tally->joints();
  ASSERT_EQ(joints.size(), 3u);
  EXPECT_EQ(joints[0].a, "man 0 leg");
  EXPECT_EQ(joints[0].b, "man 1 leg");
  EXPECT_EQ(joints[0].contacts, 2u);
  EXPECT_EQ(joints[1].a, "man 0 arm");

  const std::vector<TouchTally::Row> parts = tally->parts();
  ASSERT_EQ(parts.size(), 3u);
  EXPECT_EQ(parts[0].a, "man 0 body");
  EXPECT_EQ(parts[0].b, "man 1 boot");
  EXPECT_EQ(parts[0].contacts, 2u);
}

TEST(TouchTally, FindsTheWorstFrameOfJointsThatTouchWithSeveralParts) {
  const scenes::Scene scene = two_of(three_triangles());
  const auto colliders = scene::make_colliders(scene, scene::Granularity::instance, {});
  ASSERT_TRUE(colliders) << colliders.error().message;
  Result<TouchTally> tally = TouchTally::make({scene, *colliders});
  ASSERT_TRUE(tally) << tally.error().message;
  // Both joints are "leg": in frame 3 two bodies touch, in frame 5 each body and the other boot,
  // and in frame 7 all of them.
  const std::vector<std::vector<Contact>> frames = {
      {{1, 1}}, {{1, 2}, {2, 1}}, {{1, 1}, {1, 2}, {2, 1}}};
  for (std::uint32_t f = 0; f < 3; ++f) {
    scene::FrameContacts found;
    found.contacts = frames[f];
    found.pairs = {{0, 1, 0, frames[f].size()}};
    tally->add(3 + 2 * f, found);
  }
  const std::vector<TouchTally::Row> joints = tally->joints();
  ASSERT_EQ(joints.size(), 1u);
  EXPECT_EQ(joints[0].contacts, 6u);
  EXPECT_EQ(joints[0].frames, 3u);
  EXPECT_EQ(joints[0].worst, 3u);
  EXPECT_EQ(joints[0].worst_frame, 7u);
  const std::vector<TouchTally::Row> parts = tally->parts();
  ASSERT_EQ(parts.size(), 3u);
  for (const TouchTally::Row& row : parts) EXPECT_EQ(row.frames, 2u);
  EXPECT_EQ(parts[0].worst_frame, 3u);
  EXPECT_EQ(parts[1].worst_frame, 5u);
}

TEST(TouchTally, CountsEachTakeByItself) {
  scenes::Scene scene = two_of(three_triangles());
  const auto colliders = scene::make_colliders(scene, scene::Granularity::instance, {});
  ASSERT_TRUE(colliders) << colliders.error().message;
  scene.takes = {{"walk", 0, 2}, {"idle", 2, 3}};
  scene::FrameContacts found;
  found.contacts = {{0, 0}};
  found.pairs = {{0, 1, 0, 1}};
  Result<TouchTally> tally = TouchTally::make({scene, *colliders});
  ASSERT_TRUE(tally) << tally.error().message;
  for (const std::uint32_t frame : {1, 2, 4}) tally->add(frame, found);
  const std::vector<Touch> touches = tally->touches();
  ASSERT_EQ(touches.size(), 2u);
  EXPECT_EQ(touches[0].take, 1u);
  EXPECT_EQ(touches[0].contacts, 2u);
  EXPECT_EQ(touches[0].worst_frame, 2u);
  EXPECT_EQ(touches[1].take, 0u);
  EXPECT_EQ(touches[1].contacts, 1u);
  const std::vector<TouchTally::Row> joints = tally->joints();
  ASSERT_EQ(joints.size(), 2u);
  EXPECT_EQ(joints[0].clip, "\"idle\"");
  EXPECT_EQ(joints[1].clip, "\"walk\"");
}

}  // namespace
}  // namespace pelt::tools::check

#include "tools/pelt/check/touches.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <tuple>

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

/// Two characters, and the tally of their contacts.
struct TwoMen {
  TwoMen() {
    scene.characters.push_back({"man", "man.glb", 0, three_triangles()});
    scene.instances.resize(2);
    auto made = tools::scene::make_colliders(scene, tools::scene::Granularity::instance, {});
    EXPECT_TRUE(made) << made.error().message;
    colliders = std::move(*made);
  }

  TouchTally make_tally() const {
    Result<TouchTally> tally = TouchTally::make({scene, colliders});
    EXPECT_TRUE(tally) << tally.error().message;
    return std::move(*tally);
  }

  scenes::Scene scene;
  std::vector<tools::scene::Collider> colliders;
};

void add(std::uint32_t frame, const std::vector<Contact>& contacts, TouchTally& tally) {
  scene::FrameContacts found;
  found.contacts = contacts;
  found.pairs = {{0, 1, 0, contacts.size()}};
  tally.add(frame, found);
}

TEST(TouchTally, CountsByDominantJointAndPart) {
  const TwoMen men;
  TouchTally tally = men.make_tally();
  add(0, {{0, 0}, {0, 2}, {1, 2}, {2, 1}}, tally);

  const std::vector<TouchTally::Row> joints = tally.joints();
  ASSERT_EQ(joints.size(), 3u);
  EXPECT_EQ(joints[0].a, "man 0 leg");
  EXPECT_EQ(joints[0].b, "man 1 leg");
  EXPECT_EQ(joints[0].contacts, 2u);
  EXPECT_EQ(joints[1].a, "man 0 arm");

  const std::vector<TouchTally::Row> parts = tally.parts();
  ASSERT_EQ(parts.size(), 3u);
  EXPECT_EQ(parts[0].a, "man 0 body");
  EXPECT_EQ(parts[0].b, "man 1 boot");
  EXPECT_EQ(parts[0].contacts, 2u);
}

TEST(TouchTally, FindsTheWorstFrameOfJointsThatTouchWithSeveralParts) {
  const TwoMen men;
  TouchTally tally = men.make_tally();
  // Both joints are "leg": in frame 3 two bodies touch, in frame 5 each body and the other boot,
  // and in frame 7 all of them.
  add(3, {{1, 1}}, tally);
  add(5, {{1, 2}, {2, 1}}, tally);
  add(7, {{1, 1}, {1, 2}, {2, 1}}, tally);
  const std::vector<TouchTally::Row> joints = tally.joints();
  ASSERT_EQ(joints.size(), 1u);
  EXPECT_EQ(joints[0].contacts, 6u);
  EXPECT_EQ(joints[0].frames, 3u);
  EXPECT_EQ(joints[0].worst, 3u);
  EXPECT_EQ(joints[0].worst_frame, 7u);
  const std::vector<TouchTally::Row> parts = tally.parts();
  ASSERT_EQ(parts.size(), 3u);
  for (const TouchTally::Row& row : parts) EXPECT_EQ(row.frames, 2u);
  EXPECT_EQ(parts[0].worst_frame, 3u);
  EXPECT_EQ(parts[1].worst_frame, 5u);
}

TEST(TouchTally, CountsEachTakeByItself) {
  TwoMen men;
  men.scene.takes = {{"walk", 0, 2}, {"idle", 2, 3}};
  TouchTally tally = men.make_tally();
  for (const std::uint32_t frame : {1, 2, 4}) add(frame, {{0, 0}}, tally);
  const std::vector<Touch> touches = tally.touches();
  ASSERT_EQ(touches.size(), 2u);
  EXPECT_EQ(touches[0].take, 1u);
  EXPECT_EQ(touches[0].contacts, 2u);
  EXPECT_EQ(touches[0].worst_frame, 2u);
  EXPECT_EQ(touches[1].take, 0u);
  EXPECT_EQ(touches[1].contacts, 1u);
  const std::vector<TouchTally::Row> joints = tally.joints();
  ASSERT_EQ(joints.size(), 2u);
  EXPECT_EQ(joints[0].clip, "\"idle\"");
  EXPECT_EQ(joints[1].clip, "\"walk\"");
}

/// The sums of touches by their definition.
using Sums = std::map<std::tuple<std::uint32_t, TouchPlace, TouchPlace>, TouchCounts>;

Sums sums_of(const std::vector<Touch>& touches) {
  Sums sums;
  for (const Touch& touch : touches) sums[{touch.take, touch.a, touch.b}] = touch;
  return sums;
}

bool are_equal(const TouchCounts& x, const TouchCounts& y) {
  return std::tie(x.contacts, x.frames, x.worst, x.worst_frame) ==
         std::tie(y.contacts, y.frames, y.worst, y.worst_frame);
}

TEST(TouchTally, RandomFramesAreCountedAsDefined) {
  const unsigned seed = std::random_device()();
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  TwoMen men;
  men.scene.takes = {{"walk", 0, 30}, {"idle", 30, 50}};
  TouchTally tally = men.make_tally();
  const TouchPlace places[2][3] = {{{0, 0, 0}, {0, 0, 1}, {0, 1, 1}},
                                   {{1, 0, 0}, {1, 0, 1}, {1, 1, 1}}};
  Sums expected;
  std::size_t hits = 0;
  for (std::uint32_t frame = 0; frame < 50; ++frame) {
    std::vector<Contact> contacts;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint64_t> in_frame;
    for (const std::uint32_t a : {0u, 1u, 2u})
      for (const std::uint32_t b : {0u, 1u, 2u})
        for (auto n = random() % 3; n > 0; --n) {
          contacts.push_back({a, b});
          ++in_frame[{a, b}];
        }
    std::shuffle(contacts.begin(), contacts.end(), random);
    add(frame, contacts, tally);
    for (const auto& [triangles, count] : in_frame)
      expected[{frame < 30 ? 0 : 1, places[0][triangles.first], places[1][triangles.second]}].add(
          frame, count);
    hits += contacts.size();
  }
  EXPECT_GT(hits, 200u);
  const std::vector<Touch> touches = tally.touches();
  EXPECT_EQ(touches.size(), expected.size());
  const Sums found = sums_of(touches);
  ASSERT_EQ(found.size(), expected.size());
  for (const auto& [key, counts] : expected) EXPECT_TRUE(are_equal(found.at(key), counts));
  for (std::size_t i = 1; i < touches.size(); ++i)
    EXPECT_GE(touches[i - 1].contacts, touches[i].contacts);
}

/// Instances of a knight, a thief and the knight again; the two parts of a model share one name.
scenes::Scene knights_and_thief() {
  scenes::Scene scene;
  for (const char* name : {"knight", "thief", "caf\xE9"}) {
    scenes::Character character;
    character.name = name;
    character.asset.parts.resize(2);
    character.asset.parts[0].node = character.asset.parts[1].node = "body";
    character.asset.parts[0].material = character.asset.parts[1].material = "skin";
    character.asset.nodes.resize(1);
    character.asset.nodes[0].name = "hips";
    character.asset.joints.resize(1);
    scene.characters.push_back(std::move(character));
  }
  for (const std::uint32_t character : {0u, 1u, 0u, 2u}) {
    scenes::Instance instance;
    instance.character = character;
    scene.instances.push_back(instance);
  }
  return scene;
}

TEST(TouchName, CountsInstancesByTheirModel) {
  const scenes::Scene scene = knights_and_thief();
  const scene::StagedScene staged(scene, {});
  EXPECT_EQ(touch_name(staged, {0, 1, 0}), (TouchName{{"knight", 0, "body:skin"}, "hips"}));
  EXPECT_EQ(touch_name(staged, {1, 1, 0}), (TouchName{{"thief", 0, "body:skin"}, "hips"}));
  EXPECT_EQ(touch_name(staged, {2, 1, 0}), (TouchName{{"knight", 1, "body:skin"}, "hips"}));
  EXPECT_EQ(in_words(staged, {2, 1, 0}), "knight 2 body:skin hips");
}

TEST(TouchName, IsTheTextThatFilesContain) {
  const scenes::Scene scene = knights_and_thief();
  const scene::StagedScene staged(scene, {});
  EXPECT_EQ(touch_name(staged, {3, 0, 0}).body.model, "caf\xEF\xBF\xBD");
}

/// Comparing all instances with each other would take 10^11 steps, which is minutes.
TEST(TouchName, CountsInstancesInTimeLinearInInstances) {
  scenes::Scene scene = knights_and_thief();
  scene.instances.resize(400'000, scene.instances[0]);
  const scene::StagedScene staged(scene, {});
  for (std::uint32_t i = 4; i < scene.instances.size(); ++i)
    ASSERT_EQ(staged.names->copy(i), i - 2);
  EXPECT_EQ(touch_name(staged, {399'999, 1, 0}),
            (TouchName{{"knight", 399'997, "body:skin"}, "hips"}));
}

}  // namespace
}  // namespace pelt::tools::check

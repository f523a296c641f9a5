#include "tools/pelt/scene/scene_query.hpp"

#include "support/contains.hpp"
#include "tools/pelt/methods/command_methods.hpp"
#include "tools/pelt/scene/scene_glb.hpp"
#include "tools/scene/walkers.hpp"

namespace pelt::tools::scene {
namespace {

using test::colliders_of;
using test::palettes_of;
using test::walkers;

TEST(PoseInstances, RefuseScenesTooLargeForAGlb) {
  scenes::Scene scene;
  scene.name = "crowd.json";
  scene.characters.resize(1);
  scene.characters[0].asset.rest_positions.resize(1000000);
  scene.instances.resize(200);
  const Result<std::vector<PosedInstance>> posed = pose_instances(scene, 0, {});
  ASSERT_FALSE(posed);
  EXPECT_EQ(
      posed.error().message,
      "crowd.json: the posed characters take 4577 MiB, more than a .glb file can contain: use "
      "fewer instances");
}

TEST(SceneQuery, PartsOfOneInstanceCollideAlikeAsACrowdAndPairByPair) {
  const scenes::Scene scene = walkers();
  auto colliders = colliders_of(scene);
  colliders.push_back(colliders.front());
  colliders.back().first_triangle = 1000;
  const Palettes palettes = palettes_of(scene, 6);
  SceneQuery crowd(colliders, methods::kOnDemand);
  SceneQuery pairs(colliders, methods::kOnDemand.make());
  for (const std::uint32_t max_contacts : {UINT32_MAX, 3u}) {
    FrameContacts by_crowd, by_pairs;
    ASSERT_TRUE(crowd.set_palettes(palettes));
    ASSERT_TRUE(pairs.set_palettes(palettes));
    crowd.collide({.max_contacts = max_contacts}, by_crowd);
    pairs.collide({.max_contacts = max_contacts}, by_pairs);
    EXPECT_EQ(by_crowd.contacts, by_pairs.contacts);
    ASSERT_EQ(by_crowd.pairs.size(), by_pairs.pairs.size());
    EXPECT_EQ(by_crowd.pairs.size(), 3u);
    for (std::size_t i = 0; i < by_pairs.pairs.size(); ++i) {
      EXPECT_EQ(by_crowd.pairs[i].a, by_pairs.pairs[i].a);
      EXPECT_EQ(by_crowd.pairs[i].b, by_pairs.pairs[i].b);
      EXPECT_EQ(by_crowd.pairs[i].begin, by_pairs.pairs[i].begin);
      EXPECT_EQ(by_crowd.pairs[i].end, by_pairs.pairs[i].end);
    }
  }
}

/// Creatures in a dense row.
scenes::Scene row(std::uint32_t count) {
  scenes::Scene scene = walkers();
  scene.instances.resize(count);
  for (std::uint32_t i = 0; i < count; ++i) {
    scene.instances[i].character = i % 2;
    scene.instances[i].translation = {0.6 * i, 0, 0.1 * (i % 3)};
  }
  return scene;
}

TEST(SceneQuery, AnswersAlikeOnAnyNumberOfThreads) {
  const scenes::Scene scene = row(300);
  const auto colliders = colliders_of(scene);
  SceneQuery pairs(colliders, methods::kOnDemand.make());
  FrameContacts expected, found;
  for (const std::uint32_t threads : {1u, 2u, 4u, 9u}) {
    SceneQuery crowd = SceneQuery::as_crowd(colliders, threads);
    for (std::uint32_t frame = 0; frame < 3; ++frame) {
      const Palettes palettes = palettes_of(scene, frame);
      ASSERT_TRUE(pairs.set_palettes(palettes));
      ASSERT_TRUE(crowd.set_palettes(palettes));
      pairs.collide({}, expected);
      crowd.collide({}, found);
      EXPECT_GT(expected.contacts.size(), 100u);
      EXPECT_EQ(found.contacts, expected.contacts) << threads;
      EXPECT_EQ(found.pairs.size(), expected.pairs.size()) << threads;
    }
  }
}

TEST(SceneQuery, NamesTheFirstInstanceWhosePaletteAThreadRefused) {
  const scenes::Scene scene = row(300);
  const auto colliders = colliders_of(scene);
  Palettes palettes = palettes_of(scene, 0);
  for (const std::uint32_t refused : {299u, 141u, 140u})
    palettes.joints[refused][3].m[5] = std::numeric_limits<float>::quiet_NaN();
  for (const std::uint32_t threads : {1u, 2u, 4u}) {
    SceneQuery crowd = SceneQuery::as_crowd(colliders, threads);
    const auto posed = crowd.set_palettes(palettes);
    ASSERT_FALSE(posed);
    EXPECT_TRUE(test::contains(posed.error().message, "instances[140]"));
  }
}

TEST(SceneQuery, QueriesTheCrowdInsteadOfEveryPair) {
  scenes::Scene scene = walkers();
  scene.instances.resize(2000);
  for (std::uint32_t i = 0; i < 2000; ++i)
    scene.instances[i].translation = {3.0 * (i % 50), 0, 3.0 * (i / 50)};
  const auto colliders = colliders_of(scene);
  const Palettes palettes = palettes_of(scene, 0);
  SceneQuery query(colliders, methods::kOnDemand);
  ASSERT_TRUE(query.set_palettes(palettes));
  FrameContacts found;
  query.collide({}, found);
  EXPECT_TRUE(found.pairs.empty());
  EXPECT_LT(query.work().node_pairs, 2000u);
  EXPECT_EQ(query.work().refits, 2000u);
}

TEST(SceneQuery, RefusedPaletteNamesItsInstance) {
  const scenes::Scene scene = walkers();
  const auto colliders = colliders_of(scene);
  Palettes palettes = palettes_of(scene, 0);
  palettes.joints[1][3].m[5] = std::numeric_limits<float>::quiet_NaN();
  SceneQuery query(colliders, methods::kPaper);
  const auto posed = query.set_palettes(palettes);
  ASSERT_FALSE(posed);
  EXPECT_TRUE(test::contains(posed.error().message, "instances[1]"));
}

}  // namespace
}  // namespace pelt::tools::scene

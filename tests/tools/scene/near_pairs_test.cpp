#include "tools/pelt/scene/scene_poses.hpp"

#include <pelt/distance.hpp>

#include "tools/pelt/check/frame_query.hpp"
#include "tools/scene/walkers.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace pelt::tools::scene {
namespace {

scenes::Scene creatures(std::uint32_t count) {
  scenes::Scene scene;
  scene.characters.push_back(*scenes::generate_character(scenes::CreatureOptions{1000, 24, 1}));
  scene.instances.resize(count);
  return scene;
}

TEST(NearPairs, ContainAllPairsThatAreNearAndNotAllPairs) {
  const std::uint32_t seed = std::random_device()();
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> place(-3, 3);
  scenes::Scene scene = creatures(24);
  for (scenes::Instance& instance : scene.instances)
    instance.translation = {place(random), place(random), place(random)};
  const auto colliders = test::colliders_of(scene);
  ScenePoses posed(colliders);
  ASSERT_TRUE(posed.set_palettes(test::palettes_of(scene, 0)));
  const std::span<Pose> poses = posed.poses();
  constexpr double kDistance = 0.25;
  NearPairs near_pairs;
  const std::span<const CrowdPair> pairs = near_pairs.find(poses, kDistance);
  EXPECT_TRUE(std::is_sorted(pairs.begin(), pairs.end()));
  Scratch scratch;
  std::size_t within = 0;
  for (std::uint32_t a = 0; a < poses.size(); ++a)
    for (std::uint32_t b = a + 1; b < poses.size(); ++b) {
      if (!is_within(poses[a], poses[b], kDistance, scratch)) continue;
      ++within;
      EXPECT_TRUE(std::binary_search(pairs.begin(), pairs.end(), CrowdPair{a, b}));
    }
  EXPECT_GT(within, 0u);
  EXPECT_LT(pairs.size(), poses.size() * (poses.size() - 1) / 2);
}

TEST(NearPairs, LeaveAClearanceQueryNoWorkBetweenThoseThatAreFarApart) {
  scenes::Scene scene = creatures(2000);
  for (std::uint32_t i = 0; i < 2000; ++i)
    scene.instances[i].translation = {5.0 * (i % 50), 0, 5.0 * (i / 50)};
  scene.instances[1].translation = scene.instances[0].translation;
  check::CheckSettings settings;
  settings.options.clearance = 0.1;
  settings.max_contacts = 1;
  auto stage = check::Stage::make(scene, settings);
  ASSERT_TRUE(stage) << stage.error().message;
  ASSERT_TRUE(stage->prepare());
  check::FrameAnswer answer;
  ASSERT_TRUE(check::FrameQuery(*stage, 1).ask(0, answer));
  ASSERT_EQ(answer.found.pairs.size(), 1u);
  EXPECT_EQ(answer.found.pairs[0].b, 1u);
  EXPECT_LT(answer.work.node_pairs, 2000u);  // of 1,999,000 pairs
}

}  // namespace
}  // namespace pelt::tools::scene

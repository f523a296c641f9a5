#include "tools/pelt/check/touches.hpp"

#include <gtest/gtest.h>

namespace pelt::tools::check {
namespace {

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

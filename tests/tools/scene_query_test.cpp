#include "tools/pelt/scene_query.hpp"

#include "tools/pelt/contact_hash.hpp"
#include "tools/pelt/posed_instances.hpp"

#include <gtest/gtest.h>

namespace pelt::tools {
namespace {

TEST(PoseInstances, RefuseWhatNoGlbCanHold) {
  scenes::Scene scene;
  scene.name = "crowd.json";
  scene.characters.resize(1);
  scene.characters[0].asset.rest_positions.resize(1000000);
  scene.instances.resize(200);
  const Result<std::vector<PosedInstance>> posed = pose_instances(scene, 0, {});
  ASSERT_FALSE(posed);
  EXPECT_EQ(
      posed.error().message,
      "crowd.json: its posed characters take 4577 MiB, more than a .glb can hold: make scenes "
      "of fewer instances");
}

/// Two small creatures that walk through each other.
scenes::Scene walkers() {
  scenes::Scene scene;
  for (const scenes::CreatureOptions& options :
       {scenes::CreatureOptions{1000, 24, 1}, scenes::CreatureOptions{1200, 45, 2}}) {
    Result<scenes::Character> character = scenes::generate_character(options);
    EXPECT_TRUE(character);
    scene.characters.push_back(std::move(*character));
  }
  scene.fps = 6;
  scene.frame_count = 12;
  scene.instances.resize(2);
  scene.instances[0].clip = scene.instances[1].clip = "walk";
  scene.instances[0].translation = {-0.1, 0, -0.9};
  scene.instances[0].velocity = {0, 0, 0.9};
  scene.instances[1].character = 1;
  scene.instances[1].translation = {0.1, 0, 0.9};
  scene.instances[1].rotation = {0, 1, 0, 0};
  scene.instances[1].velocity = {0, 0, -0.9};
  return scene;
}

TEST(SceneQuery, CreaturesCollideAlikeByEveryMethod) {
  const scenes::Scene scene = walkers();
  const auto colliders = make_colliders(scene, Granularity::instance, {});
  ASSERT_TRUE(colliders) << colliders.error().message;
  asset::SampleScratch scratch;
  Palettes palettes;
  std::vector<std::uint64_t> hashes;
  for (const std::string_view name : bench::method_names()) {
    SceneQuery query(*colliders, *bench::find_method(name));
    FrameContacts found;
    ContactHash hash;
    std::size_t in_contact = 0;
    for (std::uint32_t frame = 0; frame < scene.frame_count; ++frame) {
      sample_palettes(scene, frame, scratch, palettes);
      ASSERT_TRUE(query.set_palettes(palettes));
      query.collide({}, found);
      hash.add(frame, found);
      in_contact += !found.contacts.empty();
    }
    EXPECT_GE(in_contact, 4u);
    EXPECT_LT(in_contact, scene.frame_count);
    hashes.push_back(hash.value());
    EXPECT_EQ(hashes.back(), hashes.front()) << name;
  }
}

TEST(SceneQuery, RefusedPaletteNamesItsInstance) {
  const scenes::Scene scene = walkers();
  const auto colliders = make_colliders(scene, Granularity::instance, {});
  ASSERT_TRUE(colliders) << colliders.error().message;
  asset::SampleScratch scratch;
  Palettes palettes;
  sample_palettes(scene, 0, scratch, palettes);
  palettes[1][3].m[5] = std::numeric_limits<float>::quiet_NaN();
  SceneQuery query(*colliders, bench::MethodKind::paper);
  const auto posed = query.set_palettes(palettes);
  ASSERT_FALSE(posed);
  EXPECT_NE(posed.error().message.find("instances[1]"), std::string::npos);
}

}  // namespace
}  // namespace pelt::tools

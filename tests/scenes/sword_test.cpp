#include "scenes/demo.hpp"

#include <pelt/pelt.hpp>

#include "scenes/character_glb.hpp"

#include <gtest/gtest.h>

namespace pelt::scenes {
namespace {

TEST(Sword, IsClosedAndValid) {
  const asset::Asset sword = make_sword();
  EXPECT_EQ(sword.triangles.size(), 26u);
  const auto model = build_model(sword.mesh());
  ASSERT_TRUE(model) << model.error().message;
  EXPECT_TRUE(model->surface().is_closed());
}

TEST(Sword, IsTheSameFromItsFile) {
  const asset::Asset sword = make_sword();
  const auto loaded = asset::load_gltf(character_glb(sword), {});
  ASSERT_TRUE(loaded) << loaded.error().message;
  EXPECT_EQ(loaded->rest_positions, sword.rest_positions);
  EXPECT_EQ(loaded->triangles, sword.triangles);
  EXPECT_EQ(loaded->joints.size(), 1u);
  ASSERT_NE(loaded->find_clip("swing"), nullptr);
  EXPECT_EQ(loaded->find_clip("swing")->duration, 0.4f);
}

/// Returns the posed tip at a time.
Vec3 tip_at(const asset::Asset& sword, const SkinnedModel& model, float seconds) {
  asset::SampleScratch scratch;
  std::vector<Matrix4> palette(1);
  asset::sample_palette(sword, sword.find_clip("swing"), seconds, Matrix4(), scratch, palette);
  Pose pose(model);
  EXPECT_TRUE(pose.set_palette(palette));
  std::vector<Vec3> positions(model.vertex_count());
  posed_vertices(pose, positions);
  return positions.back();
}

TEST(Sword, SwingsFromFrontToBack) {
  const asset::Asset sword = make_sword();
  const auto model = build_model(sword.mesh());
  ASSERT_TRUE(model);
  EXPECT_NEAR(tip_at(sword, *model, 0).z, 0.9f, 1e-6f);
  EXPECT_NEAR(tip_at(sword, *model, 0.1f + 1.0f / 12).x, -0.9f, 1e-6f);
  EXPECT_NEAR(tip_at(sword, *model, 0.3f).z, -0.9f, 1e-6f);
}

}  // namespace
}  // namespace pelt::scenes

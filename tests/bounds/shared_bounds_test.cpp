/// Bounds of real characters in all their clips.

#include <pelt/asset.hpp>
#include <pelt/bounds.hpp>

#include "bounds/box_of_triangles.hpp"
#include "support/values.hpp"

#include <gtest/gtest.h>

#include <filesystem>

namespace pelt {
namespace {

/// The mean, over three axes, of the relative excess length of a box over the exact one.
double looseness(const Box& box, const Box& exact) {
  const auto ratio = [](float low, float high, float exact_low, float exact_high) {
    return static_cast<double>(high - low) / static_cast<double>(exact_high - exact_low);
  };
  return (ratio(box.low.x, box.high.x, exact.low.x, exact.high.x) +
          ratio(box.low.y, box.high.y, exact.low.y, exact.high.y) +
          ratio(box.low.z, box.high.z, exact.low.z, exact.high.z)) /
         3;
}

class SharedBounds : public testing::TestWithParam<const char*> {};

TEST_P(SharedBounds, AreExactAndGuaranteedOnesAreClose) {
  const auto path = std::filesystem::path(PELT_SHARED_DIR) / "models" / GetParam();
  if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is not there";
  const Result<asset::Asset> asset = asset::load_gltf(path);
  ASSERT_TRUE(asset) << asset.error().message;
  Pose pose(*build_model(asset->mesh(), {.off_weights = OffWeights::renormalise}));
  const VertexGroups joints = group_by_joint(pose.model());
  asset::SampleScratch scratch;
  std::vector<Matrix4> palette(pose.model().joint_count());
  for (const asset::Clip& clip : asset->clips) {
    constexpr int kFrames = 6;
    double loose = 0, loose_at_three = 0;
    for (int frame = 0; frame < kFrames; ++frame) {
      asset::sample_palette(*asset, &clip, clip.duration * static_cast<float>(frame) / kFrames, {},
                            scratch, palette);
      ASSERT_TRUE(pose.set_palette(palette));
      const std::vector<Vec3> positions = test::all_posed(pose);
      const Box exact = test::box_of(asset->triangles, positions);
      const Bounds guaranteed = test::bounds_of(pose), three = test::bounds_of(pose, 3);
      EXPECT_TRUE(test::encloses(guaranteed.box, exact)) << clip.name;
      EXPECT_TRUE(test::encloses(guaranteed.sphere, asset->triangles, positions)) << clip.name;
      EXPECT_TRUE(test::encloses(three.box, exact)) << clip.name;
      EXPECT_TRUE(test::same_bits(test::exact_bounds_of(pose).box, exact)) << clip.name;
      for (std::uint32_t j = 0; j < joints.count(); ++j)
        EXPECT_TRUE(test::encloses(test::group_box(pose, joints, j),
                                   test::exact_group_box(pose, joints, j)));
      loose += looseness(guaranteed.box, exact) / kFrames;
      loose_at_three += looseness(three.box, exact) / kFrames;
    }
    EXPECT_LE(loose_at_three, loose) << clip.name;
    if (GetParam() == std::string("human.glb")) {
      EXPECT_LT(loose, 1.25) << clip.name;
      EXPECT_LT(loose_at_three, 1.15) << clip.name;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Models, SharedBounds,
                         testing::Values("human.glb", "human_8inf.glb", "knight.glb",
                                         "fox_khronos.glb", "frog.glb", "cesium_man.glb"));

}  // namespace
}  // namespace pelt

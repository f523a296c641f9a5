/// Volumes of real characters with themselves, against intersections with a copy.

#include <pelt/asset.hpp>
#include <pelt/inside.hpp>
#include <pelt/self_filter.hpp>

#include "self_volume_reference.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace pelt::test {
namespace {

struct Case {
  const char* model;
  std::size_t most_clips;
  int frames, least_overlaps;
};

class SelfVolumeOfCharacters : public testing::TestWithParam<Case> {};

TEST_P(SelfVolumeOfCharacters, EqualsThatOfACopy) {
  const auto path = std::filesystem::path(PELT_SHARED_DIR) / "models" / GetParam().model;
  if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is not there";
  const Result<asset::Asset> asset = asset::load_gltf(path);
  ASSERT_TRUE(asset) << asset.error().message;
  Pose pose(*build_model(asset->mesh()));
  ASSERT_TRUE(pose.model().surface().is_closed());
  Scratch scratch;
  asset::SampleScratch samples;
  std::vector<Matrix4> palette(pose.model().joint_count());
  int overlaps = 0;
  const std::size_t clips = std::min(asset->clips.size(), GetParam().most_clips);
  for (const asset::Clip& clip : std::span(asset->clips).first(clips))
    for (int frame = 0; frame < GetParam().frames; ++frame) {
      SCOPED_TRACE(testing::Message() << "clip " << clip.name << ", frame " << frame);
      const float share = static_cast<float>(frame) / static_cast<float>(GetParam().frames);
      asset::sample_palette(*asset, &clip, clip.duration * share, {}, samples, palette);
      ASSERT_TRUE(pose.set_palette(palette));
      Volume found;
      self_intersection_volume(pose, scratch, found);
      const Volume expected = volume_with_a_copy(pose);
      expect_equal_within_errors(found, expected);
      EXPECT_LT(found.error, expected.error);
      overlaps += std::abs(found.value) > found.error;
    }
  EXPECT_GE(overlaps, GetParam().least_overlaps);
}

INSTANTIATE_TEST_SUITE_P(Shared, SelfVolumeOfCharacters,
                         testing::Values(Case{"cesium_man.glb", 1, 8, 8},
                                         Case{"fox_khronos.glb", 3, 8, 18},
                                         Case{"fox_m2m.glb", 14, 3, 42}, Case{"human.glb", 4, 2, 8},
                                         Case{"human_8inf.glb", 2, 2, 4},
                                         Case{"morph_stress.glb", 3, 2, 0}),
                         [](const auto& param_info) {
                           std::string name = param_info.param.model;
                           return name.substr(0, name.find('.'));
                         });

}  // namespace
}  // namespace pelt::test

#include "scenes/clip_samples.hpp"

#include <gtest/gtest.h>

namespace pelt::scenes {
namespace {

/// One joint that moves one unit along x per second, in clips of 2 s and 4 s.
asset::Asset slider() {
  asset::Asset asset;
  asset.nodes.resize(1);
  asset.joints.resize(1);
  for (const float duration : {2.0f, 4.0f}) {
    asset::Channel channel;
    channel.times = {0, duration};
    channel.values = {0, 0, 0, duration, 0, 0};
    asset.clips.push_back({std::to_string(asset.clips.size()), duration, {channel}});
  }
  return asset;
}

std::vector<float> places(const std::vector<Matrix4>& palettes) {
  std::vector<float> places;
  for (const Matrix4& matrix : palettes) places.push_back(matrix.m[12]);
  return places;
}

using Places = std::vector<float>;
using Clips = std::vector<const asset::Clip*>;

TEST(ClipSamples, LieEvenlyInOneClip) {
  const asset::Asset asset = slider();
  const Clips clips = {&asset.clips[0]};
  EXPECT_EQ(places(clip_samples(asset, clips, 4)), (Places{0.25f, 0.75f, 1.25f, 1.75f}));
  EXPECT_EQ(places(clip_samples(asset, clips, 1)), Places{1});
  EXPECT_EQ(places(clip_samples(asset, clips, 0)), Places{});
}

TEST(ClipSamples, AreSharedByClips) {
  const asset::Asset asset = slider();
  const Clips clips = {&asset.clips[1], &asset.clips[0]};
  EXPECT_EQ(places(clip_samples(asset, clips, 4)), (Places{1, 3, 0.5f, 1.5f}));
  EXPECT_EQ(places(clip_samples(asset, clips, 1)), Places{0});  // the start of the second clip
  EXPECT_EQ(places(clip_samples(asset, {}, 4)), Places{});
}

TEST(ClipSamples, ComeFromThePlayedClipsOfTheCharacter) {
  Scene scene;
  scene.characters.push_back({"a", "a.glb", 0, slider()});
  scene.characters.push_back({"b", "b.glb", 0, slider()});
  scene.instances.resize(5);
  scene.instances[0].clip = std::string("1");
  scene.instances[1].character = 1;
  scene.instances[1].clip = std::string("0");
  scene.instances[2].clip = std::string("1");
  scene.instances[3].clip = std::string("0");
  const auto clip = [&](std::size_t c, std::size_t i) {
    return &scene.characters[c].asset.clips[i];
  };
  EXPECT_EQ(played_clips(scene, 0), (Clips{clip(0, 1), clip(0, 0)}));
  EXPECT_EQ(played_clips(scene, 1), Clips{clip(1, 0)});
  scene.instances[1].clip = std::string("*");
  EXPECT_EQ(played_clips(scene, 1), (Clips{clip(1, 0), clip(1, 1)}));
  EXPECT_EQ(first_clips(scene.characters[0].asset, 1), Clips{clip(0, 0)});
  EXPECT_EQ(first_clips(scene.characters[0].asset, 6), (Clips{clip(0, 0), clip(0, 1)}));
}

}  // namespace
}  // namespace pelt::scenes

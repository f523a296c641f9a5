#include "scenes/takes.hpp"

#include "scenes/clip_samples.hpp"

#include <gtest/gtest.h>

namespace pelt::scenes {
namespace {

struct Move {
  const char* name;
  float duration;
};

/// One joint that moves one unit along x per second in each of its clips.
asset::Asset slider(const std::vector<Move>& moves) {
  asset::Asset asset;
  asset.nodes.resize(1);
  asset.joints.resize(1);
  for (const Move& move : moves) {
    asset::Channel channel;
    channel.times = {0, move.duration};
    channel.values = {0, 0, 0, move.duration, 0, 0};
    asset.clips.push_back({move.name, move.duration, {channel}});
  }
  return asset;
}

/// One instance of each of these characters, at 2 frames per second.
Scene scene_of(const std::vector<asset::Asset>& assets, const std::vector<std::string>& clips) {
  Scene scene;
  scene.fps = 2;
  for (std::uint32_t i = 0; i < assets.size(); ++i) {
    scene.characters.push_back({std::string(1, static_cast<char>('a' + i)), "a.glb", 0, assets[i]});
    scene.instances.emplace_back();
    scene.instances[i].character = i;
    scene.instances[i].clip = clips[i];
  }
  return scene;
}

float x_at(const Scene& scene, std::uint32_t instance, std::uint32_t frame) {
  asset::SampleScratch scratch;
  Matrix4 palette;
  instance_palette(scene, instance, frame, scratch, std::span(&palette, 1));
  return palette.m[12];
}

TEST(Takes, AreAbsentWithoutAnInstanceThatPlaysAllClips) {
  Scene scene = scene_of({slider({{"walk", 2}})}, {"walk"});
  scene.frame_count = 7;
  ASSERT_TRUE(plan_takes(scene));
  EXPECT_TRUE(scene.takes.empty());
  EXPECT_EQ(scene.frame_count, 7u);
  EXPECT_EQ(find_take(scene, 3), nullptr);
  EXPECT_EQ(take_index(scene, 3), 0u);
  EXPECT_EQ(frame_time(scene, 3), 1.5);
}

TEST(Takes, PlayTheClipsOneAfterTheOther) {
  Scene scene = scene_of({slider({{"walk", 2}, {"idle", 1.2f}, {"", 0.5f}})}, {"*"});
  scene.instances[0].velocity = {0, 1, 0};
  ASSERT_TRUE(plan_takes(scene));
  ASSERT_EQ(scene.takes.size(), 3u);
  EXPECT_EQ(scene.frame_count, 4u + 3 + 1);
  EXPECT_EQ(find_take(scene, 3)->clip, "walk");
  EXPECT_EQ(find_take(scene, 4)->clip, "idle");
  EXPECT_EQ(find_take(scene, 6)->clip, "idle");
  EXPECT_EQ(find_take(scene, 7)->clip, "");
  EXPECT_EQ(frame_in_take(scene, 3), 3u);
  EXPECT_EQ(frame_in_take(scene, 4), 0u);
  EXPECT_EQ(frame_in_take(scene, 6), 2u);
  EXPECT_EQ(frame_time(scene, 3), 1.5);
  EXPECT_EQ(frame_time(scene, 4), 0);
  EXPECT_EQ(x_at(scene, 0, 3), 1.5f);
  EXPECT_EQ(x_at(scene, 0, 4), 0.0f);
  EXPECT_EQ(x_at(scene, 0, 6), 1.0f);
}

TEST(Takes, EqualScenesThatPlayOneClip) {
  const asset::Asset asset = slider({{"walk", 2}, {"idle", 1.5f}});
  Scene all = scene_of({asset, asset}, {"*", "walk"});
  all.instances[0].start = 0.25;
  all.instances[1].velocity = {1, 0, 0};
  ASSERT_TRUE(plan_takes(all));
  for (const Take& take : all.takes) {
    Scene one = all;
    one.takes.clear();
    one.instances[0].clip = take.clip;
    ASSERT_EQ(take.frame_count, 4u);  // the other instance plays "walk" in each take
    for (std::uint32_t frame = 0; frame < take.frame_count; ++frame)
      for (const std::uint32_t instance : {0, 1})
        EXPECT_EQ(x_at(all, instance, take.first_frame + frame), x_at(one, instance, frame))
            << take.clip << " " << frame;
  }
}

TEST(Takes, AreSharedByCharactersWithTheSameNames) {
  Scene scene = scene_of({slider({{"walk", 1}, {"idle", 1}}), slider({{"idle", 3}, {"walk", 2}})},
                         {"*", "*"});
  ASSERT_TRUE(plan_takes(scene));
  ASSERT_EQ(scene.takes.size(), 2u);
  EXPECT_EQ(scene.takes[0].clip, "walk");
  EXPECT_EQ(scene.takes[0].frame_count, 4u);
  EXPECT_EQ(scene.takes[1].clip, "idle");
  EXPECT_EQ(scene.takes[1].frame_count, 6u);
}

TEST(Takes, AreRefusedForCharactersWithDifferentNames) {
  Scene scene = scene_of({slider({{"walk", 1}}), slider({{"run", 1}})}, {"*", "*"});
  const Result<void> planned = plan_takes(scene);
  ASSERT_FALSE(planned);
  EXPECT_EQ(planned.error().message,
            "\"a\" and \"b\" have different clips, so \"*\" cannot play the clips of both: name "
            "one clip for one of them");
}

TEST(Takes, AreRefusedIfTheyAreTooLong) {
  Scene scene = scene_of({slider({{"walk", 300'000}, {"idle", 300'000}})}, {"*"});
  const Result<void> planned = plan_takes(scene);
  ASSERT_FALSE(planned);
  EXPECT_EQ(planned.error().message,
            "all clips together have more than 1000000 frames: lower the frame rate");
}

TEST(Takes, NeedClipsWithDistinctNames) {
  const Scene none = scene_of({slider({})}, {"*"});
  const Result<void> nothing = check_clip(none, 0);
  ASSERT_FALSE(nothing);
  EXPECT_EQ(nothing.error().message, "\"a\" has no clips, so \"*\" has nothing to play");
  const Scene twice = scene_of({slider({{"walk", 1}, {"run", 1}, {"walk", 2}})}, {"*"});
  const Result<void> doubled = check_clip(twice, 0);
  ASSERT_FALSE(doubled);
  EXPECT_EQ(doubled.error().message,
            "\"a\" has several clips named \"walk\", which \"*\" cannot tell apart: give each clip "
            "its own name");
}

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

#include "scenes/scene_text.hpp"

#include "scenes/scene_file.hpp"

#include <gtest/gtest.h>

namespace pelt::scenes {
namespace {

constexpr const char* kText = R"({
  "models": {
    "head": {"face": {"triangles": 1000, "seed": 3}},
    "man": {"creature": {"triangles": 1200, "joints": 21, "seed": 2}}
  },
  "frames": {"count": 7, "fps": 23.976},
  "instances": [
    {"model": "man", "clip": "walk", "start": 0.1, "speed": -1.3, "translation": [0.1, 0.2, 0.3],
     "rotation": [0, 0.6, 0, 0.8], "scale": 1.1, "velocity": [0.7, 0, -0.9]},
    {"model": "head", "morph_weights": {"smile": 0.3}},
    {"model": "head", "clip": "talk", "morph_weights": [0, 0.7]},
    {"model": "man", "clip": null}
  ],
  "ignore": [["head", "man/*"]]
})";

TEST(SceneText, IsReadAsTheSameScene) {
  const auto first = parse_scene(kText, ".");
  ASSERT_TRUE(first) << first.error().message;
  const std::vector<std::string> no_files(first->characters.size());
  const auto second = parse_scene(scene_text(*first, no_files), ".");
  ASSERT_TRUE(second) << second.error().message;
  EXPECT_EQ(second->frame_count, 7u);
  EXPECT_EQ(second->fps, 23.976);
  ASSERT_EQ(second->ignore.size(), 1u);
  EXPECT_EQ(second->ignore[0].b, "man/*");
  ASSERT_EQ(second->instances.size(), 4u);
  asset::SampleScratch scratch;
  for (std::uint32_t i = 0; i < 4; ++i) {
    const asset::Asset& asset = first->characters[first->instances[i].character].asset;
    std::vector<Matrix4> palette_a(asset.joints.size()), palette_b = palette_a;
    std::vector<float> weights_a(asset.morph_targets.size()), weights_b = weights_a;
    for (const std::uint32_t frame : {0u, 3u, 6u}) {
      instance_palette(*first, i, frame, scratch, palette_a);
      instance_palette(*second, i, frame, scratch, palette_b);
      instance_morph_weights(*first, i, frame, weights_a);
      instance_morph_weights(*second, i, frame, weights_b);
      for (std::size_t j = 0; j < palette_a.size(); ++j)
        EXPECT_EQ(palette_a[j].m, palette_b[j].m) << i << ", frame " << frame << ", joint " << j;
      EXPECT_EQ(weights_a, weights_b) << i << ", frame " << frame;
    }
  }
}

TEST(SceneText, HasTheChoicesOfContactsOfCharactersWithThemselves) {
  const auto text_of = [](const std::string& keys) {
    const auto scene = parse_scene(R"({"models": {"man": {"creature": {"triangles": 1000}}},
        "instances": [{"model": "man"}])" +
                                       keys + "}",
                                   ".");
    EXPECT_TRUE(scene) << scene.error().message;
    return scene_text(*scene, std::vector<std::string>(1));
  };
  const std::string none = text_of("");
  EXPECT_EQ(none.find("self"), std::string::npos);
  for (const std::string keys :
       {R"(, "self": true, "self_rings": 0, "self_always": 0.95)",
        R"(, "self": "only", "self_at_rest": "keep", "self_always": "keep")",
        R"(, "self": false, "self_at_rest": "drop", "self_near_joints": "keep")",
        R"(, "self_near_joints": "drop")"}) {
    std::string text = text_of(keys);
    std::erase_if(text, [](char c) { return c == '\n' || c == ' '; });
    std::string wanted = keys;
    std::erase(wanted, ' ');
    EXPECT_NE(text.find(wanted + "}"), std::string::npos) << text;
  }
}

TEST(SceneText, HasTheSkinningOfEachModel) {
  auto scene = parse_scene(R"({"models": {
      "a": {"creature": {"triangles": 1000}, "skinning": "dual-quaternion"},
      "b": {"face": {"triangles": 1000}, "skinning": "linear"},
      "c": {"face": {"triangles": 1000}}}, "instances": [{"model": "a"}]})",
                           ".");
  ASSERT_TRUE(scene) << scene.error().message;
  const std::vector<std::string> paths = {"", "", "c.glb"};
  const auto read = parse_scene_file(scene_text(*scene, paths));
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(read->models[0].skinning, Skinning::dual_quaternion);
  EXPECT_EQ(read->models[1].skinning, Skinning::linear);
  EXPECT_EQ(read->models[2].skinning, std::nullopt);
  scene->characters[2].origin = std::filesystem::path("c.glb");
  scene->characters[2].skinning = Skinning::dual_quaternion;
  const auto with_file = parse_scene_file(scene_text(*scene, paths));
  ASSERT_TRUE(with_file) << with_file.error().message;
  EXPECT_EQ(std::get<std::string>(with_file->models[2].source), "c.glb");
  EXPECT_EQ(with_file->models[2].skinning, Skinning::dual_quaternion);
}

TEST(SceneText, LeavesTheNumberOfFramesToTheClips) {
  const auto first = parse_scene(R"({"models": {"man": {"creature": {"triangles": 1000}}},
      "frames": {"fps": 10}, "instances": [{"model": "man", "clip": "*"}]})",
                                 ".");
  ASSERT_TRUE(first) << first.error().message;
  EXPECT_EQ(first->takes.size(), 2u);
  const std::vector<std::string> no_files(1);
  const auto second = parse_scene(scene_text(*first, no_files), ".");
  ASSERT_TRUE(second) << second.error().message;
  EXPECT_EQ(second->instances[0].clip, "*");
  EXPECT_EQ(second->takes.size(), 2u);
  EXPECT_EQ(second->frame_count, first->frame_count);
}

TEST(SceneText, NumbersCharactersOfTheSameName) {
  Scene scene;
  for (int i = 0; i < 3; ++i) {
    auto character = generate_character(CreatureOptions{1000, 20, 1});
    ASSERT_TRUE(character);
    scene.characters.push_back(std::move(*character));
    scene.instances.emplace_back().character = static_cast<std::uint32_t>(i);
  }
  const auto read = parse_scene(scene_text(scene, std::vector<std::string>(3)), ".");
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(read->characters.size(), 3u);
  EXPECT_EQ(read->characters[read->instances[2].character].name, "creature 3");
}

}  // namespace
}  // namespace pelt::scenes

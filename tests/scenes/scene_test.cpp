#include "scenes/scene.hpp"
#include "scenes/name_index.hpp"
#include "scenes/names.hpp"

#include <gtest/gtest.h>

#include <fstream>

namespace pelt::scenes {
namespace {

/// One joint that moves one unit along x per second, in a clip of `duration` seconds.
asset::Asset sliding_point(float duration) {
  asset::Asset asset;
  asset.nodes.resize(1);
  asset.nodes[0].local.translation = {7, 0, 0};
  asset.joints.resize(1);
  asset::Clip clip;
  clip.name = "slide";
  clip.duration = duration;
  clip.channels.resize(1);
  clip.channels[0].interpolation = asset::Interpolation::linear;
  clip.channels[0].times = duration > 0 ? std::vector<float>{0, duration} : std::vector<float>{0};
  clip.channels[0].values = {0, 0, 0};
  if (duration > 0) clip.channels[0].values.insert(clip.channels[0].values.end(), {duration, 0, 0});
  asset.clips = {clip, clip};
  asset.clips[1].name = "";
  return asset;
}

Scene scene_of(asset::Asset asset, const Instance& instance) {
  Scene scene;
  scene.characters.push_back({"point", "point.glb", 0, std::move(asset)});
  scene.instances = {instance};
  scene.frame_count = 1000;
  scene.fps = 4;
  return scene;
}

Matrix4 palette_at(const Scene& scene, std::uint32_t frame) {
  asset::SampleScratch scratch;
  Matrix4 palette;
  instance_palette(scene, 0, frame, scratch, std::span(&palette, 1));
  return palette;
}

float x_at(const Scene& scene, std::uint32_t frame) { return palette_at(scene, frame).m[12]; }

Instance playing(const char* clip, double start, double speed) {
  Instance instance;
  instance.clip = clip;
  instance.start = start;
  instance.speed = speed;
  return instance;
}

TEST(ClipTime, IsStartPlusSpeedTimesTimeModuloDuration) {
  const Scene scene = scene_of(sliding_point(2), playing("slide", 0.5, 1.5));
  EXPECT_EQ(frame_time(scene, 3), 0.75);
  EXPECT_EQ(x_at(scene, 0), 0.5f);
  EXPECT_EQ(x_at(scene, 2), 1.25f);
  EXPECT_EQ(x_at(scene, 4), 0.0f);  // 2 seconds: the loop is half-open
  EXPECT_EQ(x_at(scene, 8), 1.5f);
}

TEST(ClipTime, RunsBackwardsThroughZero) {
  const Scene scene = scene_of(sliding_point(2), playing("slide", 0.25, -1));
  EXPECT_EQ(x_at(scene, 0), 0.25f);
  EXPECT_EQ(x_at(scene, 1), 0.0f);
  EXPECT_EQ(x_at(scene, 2), 1.75f);
  EXPECT_EQ(x_at(scene, 9), 0.0f);
}

TEST(ClipTime, StaysBelowTheDurationHoweverSmallTheRest) {
  const Scene scene = scene_of(sliding_point(2), playing("slide", -1e-20, 0));
  EXPECT_EQ(x_at(scene, 0), 0.0f);
}

TEST(ClipTime, OfAClipWithoutDurationIsZero) {
  const Scene scene = scene_of(sliding_point(0), playing("slide", 3, 1));
  EXPECT_EQ(x_at(scene, 5), 0.0f);
}

TEST(ClipTime, WithoutClipTheNodesStandInTheirDefaultPose) {
  EXPECT_EQ(x_at(scene_of(sliding_point(2), {}), 3), 7.0f);
  EXPECT_EQ(x_at(scene_of(sliding_point(2), playing("", 0, 1)), 3), 0.75f);
}

TEST(Placement, TurnsThenMoves) {
  Instance instance;
  instance.translation = {1, 2, 3};
  instance.rotation = {0, 0.6, 0, 0.8};
  instance.scale = 2;
  instance.velocity = {0, 4, 0};
  const Matrix4 m = palette_at(scene_of(sliding_point(2), instance), 2);
  // The node is at (7, 0, 0); the rotation about y has cosine 0.28 and sine 0.96; t = 0.5.
  EXPECT_FLOAT_EQ(m.m[0], 2 * 0.28f);
  EXPECT_FLOAT_EQ(m.m[2], -2 * 0.96f);
  EXPECT_FLOAT_EQ(m.m[5], 2);
  EXPECT_FLOAT_EQ(m.m[12], 1 + 14 * 0.28f);
  EXPECT_FLOAT_EQ(m.m[13], 4);
  EXPECT_FLOAT_EQ(m.m[14], 3 - 14 * 0.96f);
  EXPECT_EQ(m.m[15], 1);
}

TEST(Placement, NormalisesTheRotation) {
  Instance instance;
  instance.rotation = {0, 0.6, 0, 0.8};
  const Matrix4 unit = palette_at(scene_of(sliding_point(2), instance), 0);
  for (double& number : instance.rotation) number *= 1.0005;
  const Matrix4 longer = palette_at(scene_of(sliding_point(2), instance), 0);
  for (int i = 0; i < 16; ++i) EXPECT_NEAR(unit.m[i], longer.m[i], 1e-6f) << i;
}

TEST(CheckClip, NamesTheClipsThatExist) {
  EXPECT_TRUE(check_clip(scene_of(sliding_point(2), playing("slide", 0, 1)), 0));
  EXPECT_TRUE(check_clip(scene_of(sliding_point(2), playing("", 0, 1)), 0));
  const auto near = check_clip(scene_of(sliding_point(2), playing("slid", 0, 1)), 0);
  ASSERT_FALSE(near);
  EXPECT_EQ(near.error().message, "\"point\" has no clip \"slid\", did you mean \"slide\"?");
  const auto far = check_clip(scene_of(sliding_point(2), playing("walk", 0, 1)), 0);
  ASSERT_FALSE(far);
  EXPECT_EQ(far.error().message, "\"point\" has no clip \"walk\", expected one of \"slide\", \"\"");
  asset::Asset still = sliding_point(2);
  still.clips.clear();
  const auto none = check_clip(scene_of(still, playing("walk", 0, 1)), 0);
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().message, "\"point\" has no clip \"walk\", it has none");
}

Result<Scene> face_with(const std::string& weights) {
  return parse_scene(R"({"models": {"f": {"face": {"triangles": 1000}}}, "frames": {"count": 40},
                         "instances": [{"model": "f", "clip": "talk", "morph_weights": )" +
                         weights + "}]}",
                     "");
}

TEST(MorphWeights, OfAnInstanceStandWhereTheClipMovesOthers) {
  const Result<Scene> scene = face_with(R"({"smile": 0.25, "blink_l": 0})");
  ASSERT_TRUE(scene) << scene.error().message;
  std::vector<float> weights(6), of_clip(6);
  bool other = false;
  for (std::uint32_t frame = 0; frame < 40; ++frame) {
    const asset::Asset& face = scene->characters[0].asset;
    instance_morph_weights(*scene, 0, frame, weights);
    asset::sample_morph_weights(face, &face.clips[0], static_cast<float>(frame_time(*scene, frame)),
                                of_clip);
    other |= of_clip[2] != 0;
    of_clip[1] = 0.25f, of_clip[2] = 0;
    EXPECT_EQ(weights, of_clip) << frame;
  }
  EXPECT_TRUE(other) << "else the test tells nothing of the clip";
}

TEST(MorphWeights, ThatNoTargetHasAreRefused) {
  const auto refusal = [](const std::string& weights) {
    const Result<Scene> scene = face_with(weights);
    return scene ? "" : scene.error().message;
  };
  EXPECT_EQ(refusal("[1, 2, 3, 4, 5, 6]"), "");
  EXPECT_EQ(refusal("[1, 2, 3, 4, 5, 6, 7]"),
            "instances[0].morph_weights: \"f\" has 6 morph targets, found more weights than these");
  EXPECT_EQ(refusal(R"({"smle": 1})"),
            "instances[0].morph_weights: \"f\" has no morph target \"smle\", did you mean "
            "\"smile\"?");
  const Result<Scene> creature = parse_scene(R"({"models": {"c": {"creature": {"triangles": 1000}}},
                      "instances": [{"model": "c", "morph_weights": [1]}]})",
                                             "");
  ASSERT_FALSE(creature);
  EXPECT_EQ(creature.error().message, "instances[0].morph_weights: \"c\" has no morph targets");
}

TEST(LoadScene, GeneratesCreatures) {
  const std::filesystem::path path =
      std::filesystem::temp_directory_path() / "pelt_scene_test.json";
  std::ofstream(path) << R"({
    "models": {"imp": {"creature": {"triangles": 1000, "joints": 24, "seed": 3}}},
    "instances": [{"model": "imp", "clip": "walk"}]})";
  const Result<Scene> scene = load_scene(path);
  std::filesystem::remove(path);
  ASSERT_TRUE(scene) << scene.error().message;
  EXPECT_EQ(scene->name, "pelt_scene_test.json");
  ASSERT_EQ(scene->characters.size(), 1u);
  EXPECT_EQ(scene->characters[0].name, "imp");
  EXPECT_EQ(scene->characters[0].source, "creature:1000:24:3");
  EXPECT_EQ(scene->characters[0].asset.triangles.size(), 1000u);
}

TEST(LoadScene, ReadsTheSharedOnes) {
  const std::filesystem::path folder = std::filesystem::path(PELT_SHARED_DIR) / "scenes";
  if (!std::filesystem::exists(PELT_SHARED_DIR)) GTEST_SKIP() << PELT_SHARED_DIR << " is not there";
  const std::pair<const char*, std::size_t> scenes[] = {{"two_walkers.json", 2},
                                                        {"walk_through.json", 2},
                                                        {"crowd50.json", 50},
                                                        {"duel.json", 2},
                                                        {"zoo.json", 15}};
  for (const auto& [name, instances] : scenes) {
    const Result<Scene> scene = load_scene(folder / name);
    ASSERT_TRUE(scene) << scene.error().message;
    EXPECT_EQ(scene->instances.size(), instances);
  }
}

TEST(PartNames, DistinguishPartsOfOneNode) {
  asset::Asset asset;
  asset.parts.resize(2);
  asset.parts[0].node = "body";
  asset.parts[1].node = "boot";
  EXPECT_EQ(part_names(asset), (std::vector<std::string>{"body", "boot"}));
  asset.parts[1].node = "body";
  asset.parts[1].material = "leather";
  EXPECT_EQ(part_names(asset), (std::vector<std::string>{"body:0", "body:leather"}));
}

TEST(PartNames, AreThoseOfMeshesWhereNodesHaveNone) {
  asset::Asset asset;
  asset.parts.resize(1);
  EXPECT_EQ(part_names(asset), std::vector<std::string>{"part:0"});
  asset.parts[0].mesh = "cape";
  EXPECT_EQ(part_names(asset), std::vector<std::string>{"cape"});
  asset.parts.resize(2);
  EXPECT_EQ(part_names(asset), (std::vector<std::string>{"cape:0", "part:1"}));
}

/// Comparing all nodes with each other would take 10^11 steps, which is minutes.
TEST(PartNames, AreFoundInTimeLinearInParts) {
  asset::Asset asset;
  asset.parts.resize(400'000);
  for (std::size_t p = 0; p < asset.parts.size(); ++p)
    asset.parts[p].node = "node " + std::to_string(p);
  asset.parts.back().node = "node 0";
  const std::vector<std::string> names = part_names(asset);
  ASSERT_EQ(names.size(), asset.parts.size());
  EXPECT_EQ(names[0], "node 0:0");
  EXPECT_EQ(names[1], "node 1");
  EXPECT_EQ(names.back(), "node 0:399999");
}

TEST(JointName, IsItsNumberWhereTheFileHasNone) {
  asset::Asset asset;
  asset.nodes.resize(2);
  asset.joints.resize(2);
  asset.nodes[1].name = "knee";
  asset.joints[1].node = 1;
  EXPECT_EQ(joint_name(asset, 0), "joint 0");
  EXPECT_EQ(joint_name(asset, 1), "knee");
  EXPECT_EQ(joint_names(asset), (std::vector<std::string>{"joint 0", "knee"}));
}

using Numbers = std::vector<std::uint32_t>;

/// Parts "part 0" ..., then joints "hips" and "part 3".
Character character_of(std::uint32_t parts) {
  Character character;
  character.name = "knight";
  for (std::uint32_t p = 0; p < parts; ++p)
    character.asset.parts.push_back({"part " + std::to_string(p), "", "", p, 1, true});
  character.asset.joints.resize(2);
  character.asset.nodes.resize(2);
  character.asset.joints[1].node = 1;
  character.asset.nodes[0].name = "hips";
  character.asset.nodes[1].name = "part 3";
  return character;
}

TEST(NameIndex, NumbersPartsThenJoints) {
  const NameIndex index(character_of(5));
  EXPECT_EQ(index.part_count(), 5u);
  EXPECT_EQ(index.find("part 3"), (Numbers{3, 6}));
  EXPECT_EQ(index.find("knight/part 3"), (Numbers{3, 6}));
  EXPECT_EQ(index.find("hips"), Numbers{5});
  EXPECT_EQ(index.find("*"), (Numbers{0, 1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(index.find("k*t/h*"), Numbers{5});
  EXPECT_EQ(index.find("*2"), Numbers{2});
  EXPECT_EQ(index.find("part"), Numbers{});
  EXPECT_EQ(index.find("thief/hips"), Numbers{});
  EXPECT_EQ(index.find(""), Numbers{});
}

TEST(NameIndex, ComparesOnlyNamesThatStartLikeThePattern) {
  const NameIndex index(character_of(10'000));
  EXPECT_EQ(index.candidates("part 7"), 1u);
  EXPECT_EQ(index.candidates("knight/part 7"), 1u);
  EXPECT_EQ(index.candidates("part 77*"), 1u + 10u + 100u);
  EXPECT_EQ(index.candidates("nothing"), 0u);
  EXPECT_EQ(index.candidates("nothing*"), 0u);
  EXPECT_EQ(index.candidates("*7"), 2u * 10'002u);
}

TEST(NamePattern, AStarStandsForAnyCharacters) {
  EXPECT_TRUE(matches("cape", "cape"));
  EXPECT_FALSE(matches("cape", "capes"));
  EXPECT_FALSE(matches("cape", "cap"));
  EXPECT_TRUE(matches("*", ""));
  EXPECT_TRUE(matches("cape*", "cape"));
  EXPECT_TRUE(matches("*hand*", "left_hand.001"));
  EXPECT_TRUE(matches("a*b*c", "a_b_b_c"));
  EXPECT_FALSE(matches("a*b*c", "a_c_b"));
  EXPECT_TRUE(matches("*aab", "aaaaab"));
  EXPECT_FALSE(matches("", "x"));
  EXPECT_TRUE(matches("", ""));
}

}  // namespace
}  // namespace pelt::scenes

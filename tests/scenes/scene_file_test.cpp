#include "scenes/scene_file.hpp"

#include "scenes/scene_text.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fstream>
#include <set>

namespace pelt::scenes {
namespace {

TEST(SceneFile, ReadsEveryKey) {
  const Result<SceneFile> file = parse_scene_file(R"({
    "$schema": "scene.schema.json",
    "models": {"b": {"creature": {"triangles": 8270, "joints": 27, "seed": 5}}, "a": "x/a.glb"},
    "frames": {"count": 7, "fps": 12.5},
    "instances": [
      {"model": "b", "clip": "", "start": 0.25, "speed": -2, "translation": [1, 2, 3],
       "rotation": [0, 0.6, 0, 0.8], "scale": 0.5, "velocity": [0, 0, -1],
       "morph_weights": {"smile": 0.5}},
      {"model": "a", "clip": null}
    ]})");
  ASSERT_TRUE(file) << file.error().message;
  ASSERT_EQ(file->models.size(), 2u);
  EXPECT_EQ(std::get<std::string>(file->models[0].source), "x/a.glb");
  const auto& creature = std::get<CreatureOptions>(file->models[1].source);
  EXPECT_EQ(creature.triangles, 8270u);
  EXPECT_EQ(creature.joints, 27u);
  EXPECT_EQ(creature.seed, 5u);
  EXPECT_EQ(file->frame_count, 7u);
  EXPECT_EQ(file->fps, 12.5);
  const Instance& first = file->instances.at(0);
  EXPECT_EQ(first.character, 1u);
  EXPECT_EQ(first.clip, "");
  EXPECT_EQ(first.start, 0.25);
  EXPECT_EQ(first.speed, -2);
  EXPECT_EQ(first.translation, (std::array<double, 3>{1, 2, 3}));
  EXPECT_EQ(first.rotation, (std::array<double, 4>{0, 0.6, 0, 0.8}));
  EXPECT_EQ(first.scale, 0.5);
  EXPECT_EQ(first.velocity, (std::array<double, 3>{0, 0, -1}));
  ASSERT_EQ(first.morph_weights.size(), 1u);
  EXPECT_EQ(std::get<std::string>(first.morph_weights[0].target), "smile");
  EXPECT_EQ(first.morph_weights[0].weight, 0.5f);
  const Instance& second = file->instances.at(1);
  EXPECT_EQ(second.character, 0u);
  EXPECT_EQ(second.clip, std::nullopt);
  EXPECT_EQ(second.speed, 1);
  EXPECT_EQ(second.scale, 1);
}

TEST(SceneFile, ReadsFacesAndWeightsInTheirOrder) {
  const Result<SceneFile> file = parse_scene_file(R"({
    "models": {"f": {"face": {"triangles": 2000, "seed": 9}}},
    "instances": [{"model": "f", "morph_weights": [0, -1.5]}]})");
  ASSERT_TRUE(file) << file.error().message;
  const auto& face = std::get<FaceOptions>(file->models.at(0).source);
  EXPECT_EQ(face.triangles, 2000u);
  EXPECT_EQ(face.seed, 9u);
  const auto& weights = file->instances.at(0).morph_weights;
  ASSERT_EQ(weights.size(), 2u);
  EXPECT_EQ(std::get<std::uint32_t>(weights[1].target), 1u);
  EXPECT_EQ(weights[1].weight, -1.5f);
}

TEST(SceneFile, ModelsMayChooseTheirSkinning) {
  const Result<SceneFile> file = parse_scene_file(R"({"models": {
      "a": {"file": "a.glb", "skinning": "dual-quaternion"},
      "b": {"file": "b.glb"},
      "c": "c.glb",
      "d": {"creature": {"seed": 4}, "skinning": "linear"},
      "e": {"face": {}, "skinning": "dual-quaternion"}}, "instances": []})");
  ASSERT_TRUE(file) << file.error().message;
  const std::optional<Skinning> none, dual = Skinning::dual_quaternion, linear = Skinning::linear;
  const std::optional<Skinning> expected[] = {dual, none, none, linear, dual};
  for (std::size_t m = 0; m < 5; ++m) EXPECT_EQ(file->models[m].skinning, expected[m]) << m;
  EXPECT_EQ(std::get<std::string>(file->models[0].source), "a.glb");
  EXPECT_EQ(std::get<std::string>(file->models[1].source), "b.glb");
  EXPECT_EQ(std::get<CreatureOptions>(file->models[3].source).seed, 4u);
}

struct Refusal {
  const char* text;
  const char* message;  ///< its start
};

class RefusedScene : public ::testing::TestWithParam<Refusal> {};

TEST_P(RefusedScene, NamesThePlace) {
  const Result<SceneFile> file = parse_scene_file(GetParam().text);
  ASSERT_FALSE(file);
  EXPECT_EQ(file.error().message.substr(0, std::string(GetParam().message).size()),
            GetParam().message);
}

INSTANTIATE_TEST_SUITE_P(
    Outside, RefusedScene,
    ::testing::Values(
        Refusal{"", "the JSON text"}, Refusal{"{\"models\": ", "the JSON text"},
        Refusal{"[]", "expected an object, found an array"}, Refusal{"{}", "models: is missing"},
        Refusal{R"({"models": {"a": "a"}})", "instances: is missing"},
        Refusal{R"({"models": []})", "models: expected an object, found an array"},
        Refusal{R"({"models": {}})", "models: expected at least one member, found none"},
        Refusal{R"({"models": {"a": 3}})", "models.a: expected an object, found a number"},
        Refusal{R"({"models": {"a": {}}})", "models.a.creature: is missing"},
        Refusal{R"({"models": {"a": {"creature": {"seed": -1}}}})",
                "models.a.creature.seed: expected 0 to 4294967295, found -1"},
        Refusal{R"({"models": {"a": {"creature": {"joints": 56.5}}}})",
                "models.a.creature.joints: expected a whole number, found 56.5"},
        Refusal{R"({"models": {"a": {"creature": {"triangle": 1}}}})",
                "models.a.creature: unknown key \"triangle\", did you mean \"triangles\"?"},
        Refusal{R"({"models": {"a": {"creature": {}, "face": {}}}, "instances": []})",
                "models.a.face: a model is a creature or a face, not both"},
        Refusal{R"({"models": {"a": {"file": "a.glb", "creature": {}}}, "instances": []})",
                "models.a.creature: a model is a file or generated, not both"},
        Refusal{R"({"models": {"a": {"file": 3}}, "instances": []})",
                "models.a.file: expected a string, found a number"},
        Refusal{R"({"models": {"a": {"skinning": "linear"}}, "instances": []})",
                "models.a.creature: is missing"},
        Refusal{R"({"models": {"a": {"face": {}, "skinning": "dual"}}, "instances": []})",
                "models.a.skinning: expected \"linear\" or \"dual-quaternion\", found \"dual\""},
        Refusal{
            R"({"models": {"a": {"file": "a.glb", "skinning": true}}, "instances": []})",
            "models.a.skinning: expected \"linear\" or \"dual-quaternion\", found true or false"},
        Refusal{R"({"models": {"a": {"face": {"joints": 7}}}, "instances": []})",
                "models.a.face: unknown key \"joints\", expected one of \"triangles\", \"seed\""},
        Refusal{R"({"models": {"a": "a"}, "frames": 3, "instances": []})",
                "frames: expected an object, found a number"},
        Refusal{R"({"models": {"a": "a"}, "frames": {"count": 0}, "instances": []})",
                "frames.count: expected 1 to 1000000, found 0"},
        Refusal{R"({"models": {"a": "a"}, "frames": {"count": "3"}, "instances": []})",
                "frames.count: expected a number, found a string"},
        Refusal{R"({"models": {"a": "a"}, "frames": {"fps": 0}, "instances": []})",
                "frames.fps: expected 1e-06 to 1000000, found 0"},
        Refusal{R"({"models": {"a": "a"}, "frames": {"count": 3},
                    "instances": [{"model": "a", "clip": "*"}]})",
                "frames.count: cannot be combined with \"clip\": \"*\""},
        Refusal{R"({"models": {"a": "a"}, "instances": {}})",
                "instances: expected an array, found an object"},
        Refusal{R"({"models": {"a": "a"}, "instances": [], "camera": 1})",
                "unknown key \"camera\", expected one of \"$schema\", \"models\""}));

INSTANTIATE_TEST_SUITE_P(
    Instances, RefusedScene,
    ::testing::Values(
        Refusal{R"({"models": {"a": "a"}, "instances": [{"model": "a"}, 3]})",
                "instances[1]: expected an object, found a number"},
        Refusal{R"({"models": {"a": "a"}, "instances": [{}]})", "instances[0].model: is missing"},
        Refusal{R"({"models": {"knight": "a"}, "instances": [{"model": "knigth"}]})",
                "instances[0].model: \"knigth\" is not in \"models\", did you mean \"knight\"?"},
        Refusal{R"({"models": {"a": "a"}, "instances": [{"model": "a", "clp": "walk"}]})",
                "instances[0]: unknown key \"clp\", did you mean \"clip\"?"},
        Refusal{R"({"models": {"a": "a"}, "instances": [{"model": "a", "clip": 1}]})",
                "instances[0].clip: expected a string, found a number"},
        Refusal{R"({"models": {"a": "a"}, "instances": [{"model": "a", "start": true}]})",
                "instances[0].start: expected a number, found true or false"},
        Refusal{R"({"models": {"a": "a"}, "instances": [{"model": "a", "rotation": [0, 0, 1]}]})",
                "instances[0].rotation: expected 4 numbers, found 3"},
        Refusal{
            R"({"models": {"a": "a"}, "instances": [{"model": "a", "rotation": [0, 0, 0, 1.1]}]})",
            "instances[0].rotation: expected a unit quaternion x y z w, found one of length 1.1"},
        Refusal{
            R"({"models": {"a": "a"}, "instances": [{"model": "a", "rotation": [0, 0, 0, 0]}]})",
            "instances[0].rotation: expected a unit quaternion"},
        Refusal{
            R"({"models": {"a": "a"}, "instances": [{"model": "a", "translation": [0, "0", 0]}]})",
            "instances[0].translation: expected 3 numbers, found a string among them"},
        Refusal{
            R"({"models": {"a": "a"}, "instances": [{"model": "a", "velocity": [0, 1e300, 0]}]})",
            "instances[0].velocity: expected numbers within 1e12"},
        Refusal{R"({"models": {"a": "a"}, "instances": [{"model": "a", "scale": 0}]})",
                "instances[0].scale: "},
        Refusal{R"({"models": {"a": "a"}, "instances": [{"model": "a", "morph_weights": 1}]})",
                "instances[0].morph_weights: expected an object or an array, found a number"},
        Refusal{
            R"({"models": {"a": "a"}, "instances": [{"model": "a", "morph_weights": [0, "1"]}]})",
            "instances[0].morph_weights: expected a number for element 1, found a string"},
        Refusal{
            R"({"models": {"a": "a"}, "instances": [{"model": "a", "morph_weights": {"b": 1e13}}]})",
            "instances[0].morph_weights: expected a number within 1e12 for \"b\""},
        Refusal{R"({"models": {"a": "a"}, "instances": [{"model": "a", "scale": -1}]})",
                "instances[0].scale: "},
        Refusal{R"({"models": {"a": "a"}, "instances": [{"model": "a", "scale": [1, 1, 1]}]})",
                "instances[0].scale: expected a number, found an array"}));

INSTANTIATE_TEST_SUITE_P(
    Ignore, RefusedScene,
    ::testing::Values(
        Refusal{R"({"models": {"a": "a"}, "instances": [], "ignore": {"cape": "spine"}})",
                "ignore: expected an array of pairs of names, found an object"},
        Refusal{R"({"models": {"a": "a"}, "instances": [], "ignore": [["a", "b"], "cape"]})",
                "ignore: expected two names for element 1"},
        Refusal{R"({"models": {"a": "a"}, "instances": [], "ignore": [["a", "b", "c"]]})",
                "ignore: expected two names for element 0"},
        Refusal{R"({"models": {"a": "a"}, "instances": [], "ignore": [["a", 1]]})",
                "ignore: expected two names for element 0"}));

TEST(SceneFile, ReadsWhatIsIgnored) {
  const Result<SceneFile> file = parse_scene_file(
      R"({"models": {"a": "a"}, "instances": [], "ignore": [["cape", "a,b"], ["x/*", "y"]]})");
  ASSERT_TRUE(file) << file.error().message;
  ASSERT_EQ(file->ignore.size(), 2u);
  EXPECT_EQ(file->ignore[0].b, "a,b");
  EXPECT_EQ(file->ignore[1].a, "x/*");
}

std::set<std::string> keys_of(const nlohmann::json& object) {
  std::set<std::string> keys;
  for (auto member = object["properties"].begin(); member != object["properties"].end(); ++member) {
    keys.insert(member.key());
  }
  EXPECT_EQ(object["additionalProperties"], false);
  return keys;
}

template <std::size_t N>
std::set<std::string> set_of(const std::array<std::string_view, N>& keys) {
  return {keys.begin(), keys.end()};
}

TEST(SceneSchema, HasTheKeysOfTheReader) {
  std::ifstream file(PELT_DOCS_DIR "/scene.schema.json");
  const auto schema = nlohmann::json::parse(file);
  const auto& model = schema["properties"]["models"]["additionalProperties"]["oneOf"][1];
  EXPECT_EQ(keys_of(schema), set_of(kSceneKeys));
  EXPECT_EQ(keys_of(model), set_of(kModelKeys));
  const auto& skinning = model["properties"]["skinning"];
  for (const Skinning kind : {Skinning::linear, Skinning::dual_quaternion})
    EXPECT_EQ(skinning["enum"][static_cast<std::size_t>(kind)], name_of(kind));
  EXPECT_EQ(keys_of(schema["$defs"]["frames"]), set_of(kFramesKeys));
  EXPECT_EQ(keys_of(schema["$defs"]["creature"]), set_of(kCreatureKeys));
  EXPECT_EQ(keys_of(schema["$defs"]["face"]), set_of(kFaceKeys));
  EXPECT_EQ(keys_of(schema["$defs"]["instance"]), set_of(kInstanceKeys));
  const auto& ignore = schema["properties"]["ignore"];
  EXPECT_EQ(ignore["type"], "array");
  EXPECT_EQ(ignore["items"], nlohmann::json::parse(R"({"type": "array", "minItems": 2,
    "maxItems": 2, "items": {"type": "string"}})"));
}

TEST(SceneSchema, HasTheDefaultsOfTheReader) {
  std::ifstream stream(PELT_DOCS_DIR "/scene.schema.json");
  const auto schema = nlohmann::json::parse(stream);
  const Result<SceneFile> file =
      parse_scene_file(R"({"models": {"a": {"creature": {}}, "b": {"face": {}}},
                           "instances": [{"model": "a"}]})");
  ASSERT_TRUE(file) << file.error().message;
  const auto& frames = schema["$defs"]["frames"]["properties"];
  EXPECT_EQ(frames["count"]["default"], file->frame_count);
  EXPECT_EQ(frames["fps"]["default"], file->fps);
  const auto& creature = schema["$defs"]["creature"]["properties"];
  const auto& options = std::get<CreatureOptions>(file->models[0].source);
  EXPECT_EQ(creature["triangles"]["default"], options.triangles);
  EXPECT_EQ(creature["joints"]["default"], options.joints);
  EXPECT_EQ(creature["seed"]["default"], options.seed);
  const auto& face = schema["$defs"]["face"]["properties"];
  EXPECT_EQ(face["triangles"]["default"], std::get<FaceOptions>(file->models[1].source).triangles);
  EXPECT_EQ(face["seed"]["default"], std::get<FaceOptions>(file->models[1].source).seed);
  const auto& instance = schema["$defs"]["instance"]["properties"];
  EXPECT_EQ(instance["start"]["default"], file->instances[0].start);
  EXPECT_EQ(instance["speed"]["default"], file->instances[0].speed);
  EXPECT_EQ(instance["scale"]["default"], file->instances[0].scale);
  EXPECT_EQ(instance["translation"]["default"], file->instances[0].translation);
  EXPECT_EQ(instance["rotation"]["default"], file->instances[0].rotation);
  EXPECT_EQ(instance["velocity"]["default"], file->instances[0].velocity);
}

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

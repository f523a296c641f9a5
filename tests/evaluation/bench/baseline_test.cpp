/// Reads the output of `pelt bench --json`, and other files.

#include "evaluation/bench/against.hpp"

#include "tools/pelt/bench/figures.hpp"

#include <gtest/gtest.h>

namespace pelt::lab {
namespace {

using nlohmann::json;
using namespace tools::bench;

Result<Baseline> parse(const std::string& text) {
  return parse_baseline("old.json", text, kFramesFormat);
}

SceneFigures scene_with_two_methods() {
  SceneFigures scene;
  scene.scene = "walkers.json";
  scene.frames = 120;
  scene.repetitions = 9;
  scene.time = Time::wall;
  scene.skinning = {4000, 12.5};
  Figures paper;
  paper.method = "paper";
  paper.answer.hash = 0xfedcba9876543210;
  paper.times.mean_us = 97.25;
  Figures crowd = paper;
  crowd.method = "on_demand";
  crowd.asked = Asked::crowd;
  crowd.threads = 2;
  crowd.question = Question::first;
  crowd.cache = "cold";
  crowd.times.mean_us = 4.875;
  scene.figures = {paper, crowd};
  return scene;
}

std::string figures_text() {
  const Row scene = scene_json(scene_with_two_methods());
  return figures_json("pelt-bench", {scene, scene});
}

TEST(BenchBaseline, IsWhatWasWritten) {
  const auto baseline = parse(figures_text());
  ASSERT_TRUE(baseline) << baseline.error().message;
  EXPECT_EQ(baseline->path, "old.json");
  EXPECT_EQ(in_words(baseline->machine), in_words(this_machine()));
  ASSERT_EQ(baseline->scenes.size(), 2u);
  const Row written = scene_json(scene_with_two_methods());
  const Row& read = baseline->scenes[1];
  for (const char* name : {"scene", "frames", "time"}) EXPECT_EQ(read[name], written[name]) << name;
  ASSERT_EQ(read["methods"].size(), 2u);
  for (const std::size_t i : {0, 1})
    for (const char* name : {"method", "asked", "threads", "query", "cache", "hash", "mean_us"})
      EXPECT_EQ(read["methods"][i][name], written["methods"][i][name]) << name;
}

TEST(BenchBaseline, ReadsTheNamesOfVersion01) {
  json file = json::parse(figures_text());
  file["machine"]["target"] = file["machine"]["instruction_set"];
  file["machine"].erase("instruction_set");
  for (json& scene : file["scenes"]) {
    for (json& figures : scene["methods"]) {
      figures["engine"] = figures["method"];
      figures.erase("method");
    }
    scene["engines"] = scene["methods"];
    scene.erase("methods");
  }
  const auto then = parse(file.dump()), now = parse(figures_text());
  ASSERT_TRUE(then && now) << then.error().message;
  EXPECT_EQ(in_words(then->machine), in_words(now->machine));
  EXPECT_EQ(then->scenes, now->scenes);
}

/// Replaces a compared value by `value`; an empty text removes it.
struct Damage {
  const char* place;
  json value;
  const char* words;  ///< in the message
};

class DamagedBaseline : public ::testing::TestWithParam<Damage> {};

TEST_P(DamagedBaseline, IsRefusedByName) {
  json file = json::parse(figures_text());
  const json::json_pointer place(GetParam().place);
  ASSERT_TRUE(file.contains(place));
  if (GetParam().value == "")
    file.at(place.parent_pointer()).erase(place.back());
  else
    file[place] = GetParam().value;
  const auto baseline = parse(file.dump());
  ASSERT_FALSE(baseline);
  const std::string& message = baseline.error().message;
  EXPECT_EQ(message.rfind("old.json: ", 0), 0u) << message;
  EXPECT_NE(message.find(GetParam().words), std::string::npos) << message;
  EXPECT_NE(message.find("pelt bench --json"), std::string::npos) << message;
}

INSTANTIATE_TEST_SUITE_P(
    Everywhere, DamagedBaseline,
    ::testing::Values(
        Damage{"/format", "pelt-check", "format: must be pelt-bench"},
        Damage{"/format", "", "format: must be pelt-bench"},
        Damage{"/version", 2, "version: must be 1"},
        Damage{"/machine", 3, "machine: must be an object"},
        Damage{"/machine/instruction_set", "", "machine.instruction_set: is missing"},
        Damage{"/scenes", "", "scenes: is missing"},
        Damage{"/scenes", 7, "scenes: must be an array"},
        Damage{"/scenes/0", 7, "scenes[0]: must be an object"},
        Damage{"/scenes/0/scene", "", "scenes[0].scene: is missing"},
        Damage{"/scenes/0/frames", -1, "scenes[0].frames: must be a whole number"},
        Damage{"/scenes/0/time", "cpu", "scenes[0].time: must be thread or wall"},
        Damage{"/scenes/0/methods", json::object(), "scenes[0].methods: must be an array"},
        Damage{"/scenes/0/methods/1/method", 5, "scenes[0].methods[1].method: must be a string"},
        Damage{"/scenes/0/methods/1/query", "some", "methods[1].query: must be all or first"},
        Damage{"/scenes/0/methods/1/cache", "warm", "methods[1].cache: must be hot or cold"},
        Damage{"/scenes/0/methods/1/asked", "", "methods[1].asked: is missing"},
        Damage{"/scenes/0/methods/1/asked", "all", "must be pairs or crowd or self or none"},
        Damage{"/scenes/0/methods/1/threads", 1.5, "methods[1].threads: must be a whole number"},
        Damage{"/scenes/0/methods/1/hash", "abc", "hash: must be 16 hexadecimal digits"},
        Damage{"/scenes/0/methods/1/hash", "0123456789abcdeg", "hash: must be 16 hexadecimal"},
        Damage{"/scenes/0/methods/1/mean_us", 0, "mean_us: must be a number above 0"},
        Damage{"/scenes/0/methods/1/mean_us", "", "mean_us: must be a number above 0"},
        Damage{"/scenes/0/methods/1/mean_us", "fast", "mean_us: must be a number"}));

TEST(BenchBaseline, IsRefusedWhereItIsCutShort) {
  const std::string whole = figures_text();
  for (std::size_t size = 0; size < whole.size() - 2; size += 7) {
    const auto baseline = parse(whole.substr(0, size));
    ASSERT_FALSE(baseline) << size;
    EXPECT_EQ(baseline.error().message.rfind("old.json: the JSON text is ", 0), 0u);
  }
}

TEST(BenchBaseline, MustExist) {
  const auto baseline = read_baseline("no/such.json", kFramesFormat);
  ASSERT_FALSE(baseline);
  EXPECT_NE(baseline.error().message.find("no/such.json"), std::string::npos);
  EXPECT_NE(baseline.error().message.find("--json"), std::string::npos);
}

}  // namespace
}  // namespace pelt::lab

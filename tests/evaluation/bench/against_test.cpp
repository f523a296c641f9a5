/// The comparison with an earlier run, with invented figures.

#include "evaluation/bench/against.hpp"
#include "evaluation/bench/bench.hpp"
#include "tools/pelt/bench/figures.hpp"

#include <gtest/gtest.h>

#include <sstream>

namespace pelt::lab {
namespace {

using nlohmann::json;

// Reads the output of `pelt bench --json`, and other files.

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

Figures figures_of(const std::string& method, double mean_us, Question question = Question::all,
                   const std::string& cache = "hot") {
  Figures figures;
  figures.method = method;
  figures.question = question;
  figures.cache = cache;
  figures.answer.hash = 0xabc;
  figures.times.mean_us = mean_us;
  return figures;
}

/// On demand is 20 times as fast as the paper's method and 4 times as fast as eager, and takes
/// twice as long as rigid.
SceneFigures walkers() {
  SceneFigures scene;
  scene.scene = "walkers.json";
  scene.frames = 120;
  scene.figures = {figures_of("paper", 100), figures_of("eager", 20), figures_of("on_demand", 5),
                   figures_of("rigid", 2.5)};
  return scene;
}

std::vector<Row> rows_of(const std::vector<SceneFigures>& scenes) {
  std::vector<Row> rows;
  for (const SceneFigures& scene : scenes) rows.push_back(scene_json(scene));
  return rows;
}

struct Compared {
  Comparison comparison;
  std::string text;

  bool says(const std::string& words) const { return text.find(words) != text.npos; }
};

Compared compared_rows(const std::vector<Row>& then, const std::vector<SceneFigures>& now,
                       std::uint32_t margin = kNoisePercent) {
  const Baseline baseline = {"old.json", {"CPU", "GCC", "no asserts", "avx2", 2, {}, {}}, then};
  std::ostringstream out;
  const Comparison comparison =
      print_comparison(kComparedFrames, baseline, rows_of(now), margin, out);
  return {comparison, out.str()};
}

Compared compared(const std::vector<SceneFigures>& then, const std::vector<SceneFigures>& now,
                  std::uint32_t margin = kNoisePercent) {
  return compared_rows(rows_of(then), now, margin);
}

/// The words of a method's row; empty if there is no row.
std::vector<std::string> row(const std::string& text, const std::string& method) {
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream stream(line);
    const std::vector<std::string> words{std::istream_iterator<std::string>(stream), {}};
    if (words.size() > 3 && words[2] == method) return {words.begin() + 4, words.end()};
  }
  return {};
}

using Words = std::vector<std::string>;

TEST(BenchAgainst, FindsNothingWorseInTheSameRun) {
  const Compared same = compared({walkers()}, {walkers()});
  EXPECT_EQ(row(same.text, "on_demand"),
            (Words{"20.00", "20.00", "1.00", "4.00", "4.00", "1.00", "2.00", "2.00", "1.00"}));
  EXPECT_EQ(row(same.text, "eager"),
            (Words{"5.00", "5.00", "1.00", "-", "-", "-", "8.00", "8.00", "1.00"}));
  EXPECT_TRUE(same.says("against old.json: CPU, avx2, GCC, no asserts"));
  EXPECT_TRUE(same.says("walkers.json: 120 frames, thread time\n"));
  EXPECT_TRUE(same.says("0 of 5 ratios worse by more than 15 %"));
  EXPECT_FALSE(same.says("has no"));
}

TEST(BenchAgainst, LeavesOutRowsOfYardsticks) {
  const Compared same = compared({walkers()}, {walkers()});
  EXPECT_EQ(row(same.text, "paper"), Words());
  EXPECT_EQ(row(same.text, "rigid"), Words());
}

TEST(BenchAgainst, MarksAMethodThatBecameSlower) {
  SceneFigures now = walkers();
  now.figures[2].times.mean_us = 10;
  const Compared slower = compared({walkers()}, {now});
  EXPECT_EQ(row(slower.text, "on_demand"),
            (Words{"20.00", "10.00", "0.50", "worse", "4.00", "2.00", "0.50", "worse", "2.00",
                   "4.00", "2.00", "worse"}));
  EXPECT_EQ(slower.comparison.ratios, 5u);
  EXPECT_EQ(slower.comparison.worse, 3u);
  EXPECT_TRUE(slower.says("3 of 5 ratios worse"));
}

TEST(BenchAgainst, DoesNotMarkAMethodThatBecameFaster) {
  SceneFigures now = walkers();
  now.figures[2].times.mean_us = 1;
  EXPECT_EQ(compared({walkers()}, {now}).comparison.worse, 0u);
}

TEST(BenchAgainst, DoesNotMindASlowerMachine) {
  SceneFigures now = walkers();
  for (Figures& figures : now.figures) figures.times.mean_us *= 3;
  EXPECT_EQ(compared({walkers()}, {now}).comparison.worse, 0u);
}

TEST(BenchAgainst, ForgivesWhatIsWithinTheMargin) {
  SceneFigures now = walkers();
  now.figures[2].times.mean_us = 5 * 1.149;
  EXPECT_EQ(compared({walkers()}, {now}).comparison.worse, 0u);
  now.figures[2].times.mean_us = 5 * 1.151;
  EXPECT_EQ(compared({walkers()}, {now}).comparison.worse, 3u);
  EXPECT_EQ(compared({walkers()}, {now}, 16).comparison.worse, 0u);
  EXPECT_EQ(compared({walkers()}, {now}, 0).comparison.worse, 3u);
}

TEST(BenchAgainst, NamesWhatTheFileLacks) {
  SceneFigures now = walkers();
  now.figures.push_back(figures_of("hybrid", 50));
  now.figures.push_back(figures_of("on_demand", 5, Question::first, "cold"));
  now.figures.push_back(figures_of("on_demand", 5));
  now.figures.back().asked = Asked::crowd;
  now.figures.back().threads = 2;
  SceneFigures other = walkers();
  other.scene = "other.json";
  const Compared more = compared({walkers()}, {other, now});
  EXPECT_TRUE(more.says("other.json: old.json does not contain this scene\n"));
  EXPECT_TRUE(more.says("old.json has no method hybrid\n"));
  EXPECT_TRUE(more.says("old.json has no query first with cold caches\n"));
  EXPECT_TRUE(more.says("old.json has no crowd of on_demand on 2 threads\n"));
  EXPECT_FALSE(more.says("old.json has no method on_demand\n"));
  EXPECT_EQ(row(more.text, "hybrid"),
            (Words{"-", "2.00", "-", "-", "0.40", "-", "-", "20.00", "-"}));
  EXPECT_EQ(more.comparison.ratios, 5u);
}

TEST(BenchAgainst, ToleratesAFileWithoutAYardstick) {
  SceneFigures then = walkers();
  then.figures.erase(then.figures.begin());
  const Compared less = compared({then}, {walkers()});
  EXPECT_TRUE(less.says("old.json has no method paper\n"));
  EXPECT_EQ(row(less.text, "on_demand"),
            (Words{"-", "20.00", "-", "4.00", "4.00", "1.00", "2.00", "2.00", "1.00"}));
}

TEST(BenchAgainst, ToleratesASceneWithoutMethods) {
  std::vector<Row> then = rows_of({walkers()});
  then[0]["methods"] = Row::array();
  EXPECT_EQ(compared_rows(then, {walkers()}).comparison.ratios, 0u);
}

TEST(BenchAgainst, ReportsADifferentAnswerAndDoesNotCompareIt) {
  SceneFigures then = walkers(), now = walkers();
  for (SceneFigures* scene : {&then, &now})
    for (const char* method : {"paper", "on_demand"})
      scene->figures.push_back(figures_of(method, 9, Question::first));
  for (Figures& figures : now.figures)
    if (figures.question == Question::all) figures.answer.hash = 0xdef;
  const Compared different = compared({then}, {now});
  EXPECT_EQ(different.comparison.different_answers, 1u);
  EXPECT_TRUE(different.says(
      "query all: different answers: hash 0000000000000abc then, 0000000000000def now"));
  EXPECT_EQ(different.comparison.ratios, 1u) << "those of the other question remain";
  EXPECT_EQ(row(different.text, "eager"), Words());
}

TEST(BenchAgainst, DoesNotCompareOtherNumbersOfFrames) {
  SceneFigures now = walkers();
  now.frames = 30;
  for (Figures& figures : now.figures) figures.answer.hash = 0xdef;
  const Compared shorter = compared({walkers()}, {now});
  EXPECT_TRUE(shorter.says("walkers.json: 30 frames, not the 120 of old.json: not compared\n"));
  EXPECT_EQ(shorter.comparison.ratios, 0u);
  EXPECT_EQ(shorter.comparison.different_answers, 0u) << "other frames have other answers";
}

TEST(BenchAgainst, SaysWhereTimesAreOfAnotherKind) {
  SceneFigures now = walkers();
  now.time = Time::wall;
  EXPECT_TRUE(compared({walkers()}, {now}).says("wall time, thread time then\n"));
}

}  // namespace

}  // namespace pelt::lab

/// The comparison with an earlier run, with invented figures.

#include "evaluation/bench/bench.hpp"

#include <gtest/gtest.h>

#include <sstream>

namespace pelt::lab {
namespace {

using namespace tools::bench;

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

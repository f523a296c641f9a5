#include "evaluation/reproduce/drawing.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

namespace pelt::reproduce {
namespace {

const Table kTable = {"growth",
                      "Growth",
                      {{"triangles", "triangles"}, {"it_us", "it's"}, {"name", "name"}},
                      {{1000.0, 2.5, "a"}, {10000.0, Cell(), "b"}},
                      ""};
const Chart kChart = {"growth", "Don't", "growth", "triangles", {"it_us"}, "time [us]"};

TEST(GnuplotScript, HasTheDataAndQuotesWhatPeopleWrote) {
  const std::string script = gnuplot_script(kChart, kTable, "a b.svg");
  EXPECT_NE(script.find("1000\t2.5\n10000\tNaN\n"), script.npos) << script;
  EXPECT_NE(script.find("'Don''t (lower is better)'"), script.npos) << script;
  EXPECT_NE(script.find("title 'it''s'"), script.npos) << script;
  EXPECT_NE(script.find("set ylabel 'time [\u00b5s]'"), script.npos) << script;
  EXPECT_NE(script.find("logscale"), script.npos) << script;
}

TEST(GnuplotScript, TakesLogarithmsOfTheAxesThatTheChartNames) {
  Chart chart = kChart;
  chart.axes = Axes::linear;
  EXPECT_EQ(gnuplot_script(chart, kTable, "a.svg").find("logscale"), std::string::npos);
  chart.axes = Axes::logarithmic_y;
  EXPECT_NE(gnuplot_script(chart, kTable, "a.svg").find("logscale y\n"), std::string::npos);
}

TEST(GnuplotScript, BeginsLinearHeightsWhereTheChartSays) {
  Chart chart = kChart;
  chart.axes = Axes::linear;
  EXPECT_NE(gnuplot_script(chart, kTable, "a.svg").find("yrange [0:*]"), std::string::npos);
  chart.least_y = 0.9;
  EXPECT_NE(gnuplot_script(chart, kTable, "a.svg").find("yrange [0.9:*]"), std::string::npos);
}

const Table kMethods = {"methods",
                        "Methods",
                        {{"n", "n"}, {"hash_us", "hash [us]"}, {"on_demand_us", "Pelt [us]"}},
                        {{1.0, 2.0, 3.0}},
                        ""};

/// The text between the number of the series' column and its title.
std::string line_of(const std::string& script, const std::string& title) {
  const std::size_t end = script.find(" title '" + title + "'");
  EXPECT_NE(end, script.npos) << script;
  return script.substr(script.rfind("linecolor", end), end - script.rfind("linecolor", end));
}

TEST(GnuplotScript, GivesAMethodTheSameLineWhereverItStands) {
  const Chart one = {"a", "A", "methods", "n", {"hash_us", "on_demand_us"}, "time [us]"};
  const Chart other = {"a", "A", "methods", "n", {"on_demand_us", "hash_us"}, "time [us]"};
  const std::string a = gnuplot_script(one, kMethods, "a.svg");
  const std::string b = gnuplot_script(other, kMethods, "a.svg");
  EXPECT_EQ(line_of(a, "hash"), line_of(b, "hash"));
  EXPECT_EQ(line_of(a, "Pelt"), line_of(b, "Pelt"));
  EXPECT_NE(line_of(a, "Pelt"), line_of(a, "hash"));
}

TEST(GnuplotScript, HasAKeyForMoreThanOneLine) {
  Chart chart = {"a", "A", "methods", "n", {"hash_us"}, "time [us]"};
  EXPECT_NE(gnuplot_script(chart, kMethods, "a.svg").find("set key off"), std::string::npos);
  chart.y.push_back("on_demand_us");
  EXPECT_EQ(gnuplot_script(chart, kMethods, "a.svg").find("set key off"), std::string::npos);
}

TEST(GnuplotScript, LeavesRowsBeyondTheEndToTheTable) {
  Chart chart = kChart;
  chart.x_end = 1000;
  const std::string script = gnuplot_script(chart, kTable, "a.svg");
  EXPECT_NE(script.find("1000\t2.5\nEND"), script.npos) << script;
}

TEST(DrawChart, WritesAnSvg) {
  if (std::system("gnuplot --version > /dev/null 2>&1") != 0)
    GTEST_SKIP() << "gnuplot is not installed";
  const auto svg = std::filesystem::temp_directory_path() / "pelt_chart_test.svg";
  const Result<void> drawn = draw_chart(kChart, kTable, svg);
  ASSERT_TRUE(drawn) << drawn.error().message;
  std::ifstream file(svg);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  EXPECT_NE(text.find("<svg"), text.npos);
  EXPECT_NE(text.find("time [\u00b5s]"), text.npos);
  std::filesystem::remove(svg);
}

}  // namespace
}  // namespace pelt::reproduce

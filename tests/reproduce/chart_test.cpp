#include "tools/reproduce/chart.hpp"

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
  EXPECT_NE(script.find("set ylabel 'time [us]'"), script.npos) << script;
  EXPECT_NE(script.find("logscale"), script.npos) << script;
}

TEST(GnuplotScript, TakesLogarithmsOfTheAxesThatTheChartNames) {
  Chart chart = kChart;
  chart.axes = Axes::linear;
  EXPECT_EQ(gnuplot_script(chart, kTable, "a.svg").find("logscale"), std::string::npos);
  chart.axes = Axes::logarithmic_y;
  EXPECT_NE(gnuplot_script(chart, kTable, "a.svg").find("logscale y\n"), std::string::npos);
}

TEST(DrawChart, WritesAnSvg) {
  if (std::system("gnuplot --version > /dev/null 2>&1") != 0) GTEST_SKIP() << "no gnuplot here";
  const auto svg = std::filesystem::temp_directory_path() / "pelt_chart_test.svg";
  const Result<void> drawn = draw_chart(kChart, kTable, svg);
  ASSERT_TRUE(drawn) << drawn.error().message;
  std::ifstream file(svg);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  EXPECT_NE(text.find("<svg"), text.npos);
  EXPECT_NE(text.find("time [us]"), text.npos);
  std::filesystem::remove(svg);
}

}  // namespace
}  // namespace pelt::reproduce

#include "evaluation/reproduce/report.hpp"
#include "evaluation/reproduce/drawing.hpp"
#include "evaluation/reproduce/files.hpp"
#include "evaluation/reproduce/html.hpp"
#include "text/format.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <set>
#include <vector>

namespace pelt::reproduce {
namespace {

Table small_table() {
  return {"small",
          "Small & fine",
          {{"method", "method"}, {"query_us", "query [us]"}},
          {{"a, \"quoted\"", 1.5}, {"b", Cell()}, {"<c>", 26756.0}},
          ""};
}

TEST(Shown, KeepsThreeDigitsOrMore) {
  EXPECT_EQ(shown(26756.0), "26,756");
  EXPECT_EQ(shown(0.0), "0");
  EXPECT_EQ(shown(-3.0), "-3");
  EXPECT_EQ(shown(4.913), "4.91");
  EXPECT_EQ(shown(12.345), "12.3");
  EXPECT_EQ(shown(123.456), "123");
  EXPECT_EQ(shown(0.0182), "0.0182");
  EXPECT_EQ(shown(Cell()), "");
  EXPECT_EQ(shown(Cell("name")), "name");
}

TEST(Base64, IsThatOfTheRfc) {
  EXPECT_EQ(text::base64(""), "");
  EXPECT_EQ(text::base64("f"), "Zg==");
  EXPECT_EQ(text::base64("fo"), "Zm8=");
  EXPECT_EQ(text::base64("foo"), "Zm9v");
  EXPECT_EQ(text::base64("foob"), "Zm9vYg==");
  EXPECT_EQ(text::base64("\xff\xfe\xfd"), "//79");
}

TEST(Csv, QuotesWhatHasToBe) {
  EXPECT_EQ(csv_of(small_table()), "method,query_us\n\"a, \"\"quoted\"\"\",1.5\nb,\n<c>,26756\n");
}

TEST(Json, HasEveryFigure) {
  Section section;
  section.id = "one";
  section.tables = {small_table()};
  const auto json = nlohmann::json::parse(json_of({{"here"}, {section}}));
  EXPECT_EQ(json["format"], "pelt-reproduce");
  const auto& rows = json["sections"][0]["tables"][0]["rows"];
  EXPECT_EQ(rows[0]["query_us"], 1.5);
  EXPECT_TRUE(rows[1]["query_us"].is_null());
  EXPECT_EQ(rows[2]["method"], "<c>");
}

TEST(HtmlPage, EscapesNamesAndSaysWhatIsNotDrawn) {
  Section section;
  section.id = "one";
  section.tables = {small_table()};
  section.charts = {{"drawn", "Drawn", "small", "query_us", {"query_us"}, "us"},
                    {"missing", "Missing", "small", "query_us", {"query_us"}, "us"}};
  const std::string page = html_page({section}, {"here"}, {{"drawn", "foo"}});
  EXPECT_NE(page.find("Small &amp; fine"), page.npos);
  EXPECT_NE(page.find("&lt;c&gt;"), page.npos);
  EXPECT_EQ(page.find("<c>"), page.npos);
  EXPECT_NE(page.find("base64,Zm9v"), page.npos);
  EXPECT_NE(page.find("(not drawn: Missing)"), page.npos);
  EXPECT_EQ(page.find("src=\"http"), page.npos) << "the page needs nothing beside it";
}

/// A section, its tables, charts and pictures may share an id.
TEST(HtmlPage, HasNoIdTwice) {
  Section section;
  section.id = "small";
  section.tables = {small_table()};
  section.charts = {{"small", "Chart", "small", "query_us", {"query_us"}, "us"}};
  section.pictures = {{"small", "Picture", ""}};
  const std::string page = html_page({section}, {}, {{"small", "foo"}});
  std::set<std::string> ids;
  for (std::size_t at = page.find(" id=\""); at != page.npos; at = page.find(" id=\"", at + 1)) {
    const std::size_t begin = at + 5, end = page.find('"', begin);
    EXPECT_TRUE(ids.insert(page.substr(begin, end - begin)).second) << page.substr(at, 40);
  }
  EXPECT_EQ(ids, std::set<std::string>({"small", "table-small", "chart-small", "picture-small"}));
}

TEST(HtmlPage, HasEachChartBelowItsTable) {
  Section section;
  section.id = "one";
  section.tables = {small_table(), small_table()};
  section.tables[1].id = "other";
  section.charts = {{"b", "B", "other", "query_us", {"query_us"}, "us"},
                    {"a", "A", "small", "query_us", {"query_us"}, "us"}};
  const std::string page = html_page({section}, {}, {{"a", "foo"}, {"b", "foo"}});
  std::vector<std::size_t> places;
  for (const char* id : {"table-small", "chart-a", "table-other", "chart-b"})
    places.push_back(page.find(id));
  EXPECT_TRUE(std::is_sorted(places.begin(), places.end()));
  EXPECT_NE(places.back(), page.npos);
}

TEST(HtmlPage, WritesAColumnAlike) {
  Section section;
  section.tables = {small_table()};
  section.tables[0].rows[0][1] = 1.25;
  section.tables[0].rows[2][1] = 3.0;
  const std::string page = html_page({section}, {}, {});
  EXPECT_NE(page.find("<td>1.25</td>"), page.npos);
  EXPECT_NE(page.find("<td>3.00</td>"), page.npos);
}

std::vector<std::string> column(const std::vector<double>& figures) {
  const ColumnFormat format(figures);
  std::vector<std::string> all;
  for (const double figure : figures) all.push_back(format.shown(figure));
  return all;
}

using Texts = std::vector<std::string>;

TEST(ColumnFormat, WritesWholeNumbersInFull) {
  EXPECT_EQ(column({0, 7, 26756, -1234}), Texts({"0", "7", "26,756", "-1,234"}));
  EXPECT_EQ(column({}), Texts());
}

TEST(ColumnFormat, WritesAFewDecimalsInEveryRow) {
  EXPECT_EQ(column({3, 1.2, 0.45, 0}), Texts({"3.00", "1.20", "0.45", "0.00"}));
  EXPECT_EQ(column({0.3, 1}), Texts({"0.3", "1.0"}));
}

TEST(ColumnFormat, AlignsWhatLiesWithinADecade) {
  EXPECT_EQ(column({30.8812, 32, 27.66}), Texts({"30.9", "32.0", "27.7"}));
  EXPECT_EQ(column({0.99371, 1, 1.7618}), Texts({"0.994", "1.000", "1.762"}));
}

TEST(ColumnFormat, KeepsThreeDigitsOfWhatDiffersMore) {
  EXPECT_EQ(column({0.0181818, 4.9, 32, 123.456, 26756.2, 0}),
            Texts({"0.0182", "4.90", "32.0", "123", "26,756", "0"}));
  EXPECT_EQ(column({9.9961, 0.012345, -0.5}), Texts({"10.0", "0.0123", "-0.500"}));
}

TEST(WithMicroSigns, TouchesUnitsOnly) {
  EXPECT_EQ(with_micro_signs("query [us], 12.5 us; us, 3 users, bus [uses]"),
            "query [\u00b5s], 12.5 \u00b5s; us, 3 users, bus [uses]");
  EXPECT_EQ(with_micro_signs("us"), "us");
  EXPECT_EQ(with_micro_signs("4 us"), "4 \u00b5s");
}

bool has(const std::string& text, const std::string& what) { return text.find(what) != text.npos; }

struct Range {
  double low = 0, high = 0;
};

Range range_of(const std::string& commands) {
  Range range;
  const std::size_t at = commands.find("range [");
  EXPECT_EQ(std::sscanf(commands.c_str() + at, "range [%lf:%lf]", &range.low, &range.high), 2)
      << commands;
  return range;
}

TEST(LogarithmicAxis, IsLittleLongerThanItsFigures) {
  const Range range = range_of(logarithmic_axis("y", std::vector<double>{0, 2.5, 640, 90}));
  EXPECT_LT(range.low, 2.5);
  EXPECT_GT(range.low, 1.5);
  EXPECT_GT(range.high, 640);
  EXPECT_LT(range.high, 1000);
}

TEST(LogarithmicAxis, HasLabelsHoweverShortItIs) {
  const std::string decades = logarithmic_axis("x", std::vector<double>{1000, 1e6});
  EXPECT_TRUE(has(decades, "'1,000' 1000 0")) << decades;
  EXPECT_TRUE(has(decades, "'1,000,000' 1e+06 0")) << decades;
  EXPECT_TRUE(has(decades, "'' 2000 1")) << decades;
  const std::string one = logarithmic_axis("x", std::vector<double>{0.04, 0.9});
  EXPECT_TRUE(has(one, "'0.05' 0.05 0") && has(one, "'0.2' 0.2 0") && has(one, "'' 0.3 1")) << one;
  const std::string less = logarithmic_axis("x", std::vector<double>{20, 64});
  EXPECT_TRUE(has(less, "'30' 30 0") && has(less, "'60' 60 0")) << less;
}

TEST(LogarithmicAxis, BearsWhatHasNoLogarithm) {
  EXPECT_EQ(logarithmic_axis("y", std::vector<double>{0, -1}), "set logscale y\n");
  const Range range = range_of(logarithmic_axis("y", std::vector<double>{5, 5}));
  EXPECT_LT(range.low, range.high);
}

TEST(LinearAxis, IsLittleLongerThanItsFigures) {
  const Range range = range_of(linear_axis("x", std::vector<double>{3, 0, 1}));
  EXPECT_LT(range.low, 0);
  EXPECT_GT(range.low, -0.2);
  EXPECT_GT(range.high, 3);
  EXPECT_LT(range.high, 3.2);
  const Range point = range_of(linear_axis("x", std::vector<double>{2, 2}));
  EXPECT_LT(point.low, point.high);
  EXPECT_EQ(linear_axis("x", {}), "");
}

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

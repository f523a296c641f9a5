#include "evaluation/reproduce/report.hpp"

#include "evaluation/reproduce/files.hpp"
#include "evaluation/reproduce/html.hpp"
#include "text/format.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <set>

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

}  // namespace
}  // namespace pelt::reproduce

#include "tools/reproduce/report.hpp"

#include "tools/reproduce/base64.hpp"
#include "tools/reproduce/files.hpp"
#include "tools/reproduce/html.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

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
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foob"), "Zm9vYg==");
  EXPECT_EQ(base64("\xff\xfe\xfd"), "//79");
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

}  // namespace
}  // namespace pelt::reproduce

#include "asset/parsed_json.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace pelt::asset {
namespace {

using nlohmann::json;

TEST(ParsedJson, IsTheTreeOfTheParser) {
  for (const std::string text :
       {"null", "true", "-7", "18446744073709551615", "0.25", R"("a\u00e9\n")", "[]", "{}",
        R"([1, [2, [3, {}], []], {"a": [null, {"b": "c"}], "": {"d": -1.5e-3}}, false])",
        R"( {"a": {"b": {"c": [[[]]]}}, "z": [{"a": 1}, {"a": 2}]} )"}) {
    const Result<ParsedJson> parsed = parse_json(text);
    ASSERT_TRUE(parsed) << text;
    EXPECT_EQ(**parsed, json::parse(text)) << text;
  }
}

TEST(ParsedJson, UsesTheLastOfEqualKeys) {
  for (const std::string text :
       {R"({"a": 1, "a": 2})", R"({"a": [[1], [2]], "b": 3, "a": {"c": [4]}})",
        R"({"a": {"a": [1, {"a": 2}]}, "a": []})"}) {
    const Result<ParsedJson> parsed = parse_json(text);
    ASSERT_TRUE(parsed) << text;
    EXPECT_EQ(**parsed, json::parse(text)) << text;
  }
}

TEST(ParsedJson, RefusesWhatIsNotWhole) {
  for (const std::string text : {"", " \n", "{", "[1,]", "[1] 2", "{\"a\" 1}", "1e999", "nul", "[1",
                                 "{\"a\":[{}", "\"\xff\"", "[1]]"}) {
    const Result<ParsedJson> parsed = parse_json(text);
    ASSERT_FALSE(parsed) << text;
    EXPECT_EQ(parsed.error().code, ErrorCode::malformed_file);
    EXPECT_NE(parsed.error().message.find("the JSON text is "), std::string::npos);
  }
}

}  // namespace
}  // namespace pelt::asset

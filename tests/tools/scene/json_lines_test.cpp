#include "tools/pelt/scene/json_lines.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <sstream>

namespace pelt::tools::scene {
namespace {

using nlohmann::ordered_json;

TEST(JsonLine, WritesTheTextOfTheWholeValue) {
  const ordered_json pairs = {{{"a", 0}, {"name", "caf\u00e9 \u009b\xff"}}, 0.1, {1, 2}};
  std::ostringstream whole, pieces;
  write_line({{"frame", 3},
              {"time", 0.5},
              {"pairs", pairs},
              {"none", ordered_json::array()},
              {"totals", {{"frames", 1}, {"least", {7}}}},
              {"counters", {{"refits", 2}}}},
             whole);
  JsonLine line(pieces);
  line.members({{"frame", 3}, {"time", 0.5}});
  line.begin_list("pairs");
  for (const ordered_json& pair : pairs) line.item(pair);
  line.end_list();
  line.begin_list("none");
  line.end_list();
  line.begin_object("totals");
  line.members({{"frames", 1}});
  line.begin_list("least");
  line.item(7);
  line.end_list();
  line.end_object();
  line.members({{"counters", {{"refits", 2}}}});
  line.end();
  EXPECT_EQ(pieces.str(), whole.str());
}

}  // namespace
}  // namespace pelt::tools::scene

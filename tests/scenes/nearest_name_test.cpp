#include "scenes/nearest_name.hpp"

#include <gtest/gtest.h>

namespace pelt::scenes {
namespace {

constexpr std::string_view kKnown[] = {"walk", "walk_formal", "run", "T"};

TEST(NearestName, FindsTypingErrors) {
  for (const char* typo : {"wlak", "wal", "walkk", "Walk", "wak"}) {
    EXPECT_EQ(suggestion(typo, kKnown), ", did you mean \"walk\"?") << typo;
  }
  EXPECT_EQ(suggestion("ran", kKnown), ", did you mean \"run\"?");
}

TEST(NearestName, ListsAllWhereNoneIsNear) {
  EXPECT_EQ(suggestion("dance", kKnown),
            ", expected one of \"walk\", \"walk_formal\", \"run\", \"T\"");
  // Names as short as two typing errors are near to everything.
  EXPECT_NE(suggestion("X", kKnown).find("expected"), std::string::npos);
}

}  // namespace
}  // namespace pelt::scenes

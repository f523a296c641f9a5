#include "text/message.hpp"

#include <gtest/gtest.h>

namespace pelt::text {
namespace {

constexpr std::string_view kKnown[] = {"walk", "walk_formal", "run", "T"};

TEST(ClosestName, FindsTypingErrors) {
  for (const char* typo : {"wlak", "wal", "walkk", "Walk", "wak"}) {
    EXPECT_EQ(suggestion(typo, kKnown), ", did you mean \"walk\"?") << typo;
  }
  EXPECT_EQ(suggestion("ran", kKnown), ", did you mean \"run\"?");
}

TEST(ClosestName, CountsTwoSwappedCharactersAsOneError) {
  const std::vector<std::string_view> options = {"help", "html"};
  EXPECT_EQ(closest_name("htlm", options), "html");
}

TEST(ClosestName, AcceptsMoreErrorsInLongNamesAndPiecesOfNames) {
  const std::vector<std::string_view> names = {"Knight_Helmet_Visor", "Knight_Helmet", "hand_r"};
  EXPECT_EQ(closest_name("knight-hlemet", names), "Knight_Helmet");
  EXPECT_EQ(closest_name("helmet", names), "Knight_Helmet");
  EXPECT_EQ(closest_name("HAND_R", names), "hand_r");
  EXPECT_EQ(closest_name("shield", names), std::nullopt);
  EXPECT_EQ(closest_name("r", names), std::nullopt);
}

TEST(ClosestName, ListsNoMoreThanCanBeRead) {
  const std::vector<std::string_view> names(20, "joint");
  const std::string words = suggestion("sword", names);
  EXPECT_EQ(words.substr(words.size() - 18), "\"joint\" and 4 more") << words;
}

TEST(ClosestName, ListsAllWhereNoneIsNear) {
  EXPECT_EQ(suggestion("dance", kKnown),
            ", expected one of \"walk\", \"walk_formal\", \"run\", \"T\"");
  // Every name is near to a short one.
  EXPECT_NE(suggestion("X", kKnown).find("expected"), std::string::npos);
}

}  // namespace
}  // namespace pelt::text

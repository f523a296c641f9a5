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

TEST(NearestName, TakesTwoCharactersInTheWrongOrderForOneError) {
  const std::vector<std::string_view> options = {"help", "html"};
  EXPECT_EQ(nearest_name("htlm", options), "html");
}

TEST(NearestName, TakesLongNamesWithMoreErrorsAndPiecesOfNames) {
  const std::vector<std::string_view> names = {"Knight_Helmet_Visor", "Knight_Helmet", "hand_r"};
  EXPECT_EQ(nearest_name("knight-hlemet", names), "Knight_Helmet");
  EXPECT_EQ(nearest_name("helmet", names), "Knight_Helmet");
  EXPECT_EQ(nearest_name("HAND_R", names), "hand_r");
  EXPECT_EQ(nearest_name("shield", names), std::nullopt);
  EXPECT_EQ(nearest_name("r", names), std::nullopt);
}

TEST(NearestName, ListsNoMoreThanCanBeRead) {
  const std::vector<std::string_view> names(20, "joint");
  const std::string words = suggestion("sword", names);
  EXPECT_EQ(words.substr(words.size() - 18), "\"joint\" and 4 more") << words;
}

TEST(NearestName, ListsAllWhereNoneIsNear) {
  EXPECT_EQ(suggestion("dance", kKnown),
            ", expected one of \"walk\", \"walk_formal\", \"run\", \"T\"");
  // Every name is near to a short one.
  EXPECT_NE(suggestion("X", kKnown).find("expected"), std::string::npos);
}

}  // namespace
}  // namespace pelt::scenes

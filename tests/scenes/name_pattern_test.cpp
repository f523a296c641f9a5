#include "scenes/name_index.hpp"

#include <gtest/gtest.h>

namespace pelt::scenes {
namespace {

TEST(NamePattern, AStarStandsForAnyCharacters) {
  EXPECT_TRUE(matches("cape", "cape"));
  EXPECT_FALSE(matches("cape", "capes"));
  EXPECT_FALSE(matches("cape", "cap"));
  EXPECT_TRUE(matches("*", ""));
  EXPECT_TRUE(matches("cape*", "cape"));
  EXPECT_TRUE(matches("*hand*", "left_hand.001"));
  EXPECT_TRUE(matches("a*b*c", "a_b_b_c"));
  EXPECT_FALSE(matches("a*b*c", "a_c_b"));
  EXPECT_TRUE(matches("*aab", "aaaaab"));
  EXPECT_FALSE(matches("", "x"));
  EXPECT_TRUE(matches("", ""));
}

}  // namespace
}  // namespace pelt::scenes

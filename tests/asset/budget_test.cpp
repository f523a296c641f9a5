#include "asset/budget.hpp"

#include "asset/parsed_json.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace pelt::asset {
namespace {

TEST(Budget, GrowsWithTheFileAndEndsThere) {
  Budget budget;
  budget.grant(1000);
  EXPECT_TRUE(budget.take(Budget::kStart + 256'000, 1, "accessor 0"));
  const Result<void> taken = budget.take(1, 4, "accessor 1");
  ASSERT_FALSE(taken);
  EXPECT_EQ(taken.error().code, ErrorCode::malformed_file);
  EXPECT_EQ(taken.error().message,
            "accessor 1: 1 elements are out of proportion: the file would take more than 256 times "
            "its size in memory");
}

TEST(Budget, RefusesCountsWhoseBytesOverflow) {
  Budget budget;
  EXPECT_FALSE(budget.take(~std::uint64_t{0}, 12, "accessor 0"));
  EXPECT_TRUE(budget.take(Budget::kStart, 1, "accessor 1"));
}

TEST(Budget, HasAnEndHoweverLargeTheFile) {
  static_assert(sizeof(void*) == 4 || Budget::kMax == std::uint64_t{48} << 30);
  Budget budget;
  for (int i = 0; i < 3; ++i) budget.grant(Budget::kMax);
  EXPECT_TRUE(budget.take(Budget::kMax / 2, 2, "accessor 0"));
  const Result<void> taken = budget.take(1000, 1, "accessor 1");
  ASSERT_FALSE(taken);
  EXPECT_EQ(taken.error().message,
            "accessor 1: 1000 elements are out of proportion: the file would take more than " +
                std::to_string(Budget::kMax >> 20) + " MiB of memory");
}

// With 32-bit addresses, two million values are too many (tests/wasm/limits.test.mjs).
TEST(Budget, AllowsAnyNumberOfValuesInATextWhereAddressesHave64Bits) {
  std::string text = "[0";
  for (int i = 0; i < 2'100'000; ++i) text += ",0";
  EXPECT_TRUE(parse_json(text + "]"));
}

}  // namespace
}  // namespace pelt::asset

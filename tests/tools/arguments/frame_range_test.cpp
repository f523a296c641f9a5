#include "tools/pelt/arguments/values.hpp"

#include "support/contains.hpp"

#include <gtest/gtest.h>

namespace pelt::tools::arguments {
namespace {

TEST(FrameRange, IsHalfOpen) {
  const Result<FrameRange> range = parse_frame_range("3:6");
  ASSERT_TRUE(range);
  EXPECT_EQ(range->frames(), (std::vector<std::uint32_t>{3, 4, 5}));
}

TEST(FrameRange, AcceptsAStride) {
  const Result<FrameRange> range = parse_frame_range("1:8:3");
  ASSERT_TRUE(range);
  EXPECT_EQ(range->frames(), (std::vector<std::uint32_t>{1, 4, 7}));
}

TEST(FrameRange, DoesNotRunOverTheEndOfItsNumbers) {
  const Result<FrameRange> range = parse_frame_range("4294967290:4294967295:4");
  ASSERT_TRUE(range);
  EXPECT_EQ(range->frames(), (std::vector<std::uint32_t>{4294967290, 4294967294}));
}

TEST(FrameRange, RefusesWhatIsNone) {
  for (const char* text : {"", "3", "3:", ":3", "3:3", "4:3", "-1:3", "0:3:0", "0:3:1:1", "a:b",
                           "0:3 ", "0:4294967296", "0.5:3"}) {
    const Result<FrameRange> range = parse_frame_range(text);
    ASSERT_FALSE(range) << text;
    EXPECT_TRUE(test::contains(range.error().message, "--frames"));
    EXPECT_TRUE(test::contains(range.error().message, text));
  }
}

}  // namespace
}  // namespace pelt::tools::arguments

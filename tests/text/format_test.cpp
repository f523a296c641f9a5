#include "text/format.hpp"

#include <gtest/gtest.h>

namespace pelt::text {
namespace {

TEST(Text, Commas) {
  EXPECT_EQ(with_commas(0), "0");
  EXPECT_EQ(with_commas(999), "999");
  EXPECT_EQ(with_commas(1000), "1,000");
  EXPECT_EQ(with_commas(123456789), "123,456,789");
}

TEST(Text, NumbersAreTakenWholeOrNotAtAll) {
  double number = 7;
  EXPECT_TRUE(parse_number("-1.5e3", number));
  EXPECT_EQ(number, -1500);
  for (const char* text : {"", " 1", "1 ", "1,5", "x", "nan", "inf", "1e999"}) {
    EXPECT_FALSE(parse_number(text, number)) << text;
  }
  EXPECT_EQ(number, -1500);
  std::uint32_t whole = 7;
  EXPECT_FALSE(parse_whole("-1", whole));
  EXPECT_FALSE(parse_whole("1.0", whole));
  EXPECT_TRUE(parse_whole("4294967295", whole));
  EXPECT_EQ(whole, 4294967295u);
}

TEST(Text, Fields) {
  EXPECT_EQ(split("a,,b", ','), (std::vector<std::string_view>{"a", "", "b"}));
  EXPECT_EQ(split("", ','), (std::vector<std::string_view>{""}));
}

TEST(Text, Words) {
  EXPECT_EQ(hex16(0xabc), "0000000000000abc");
  EXPECT_EQ(fixed(0.125, 2), "0.12");
  EXPECT_EQ(counted(1, "frame"), "1 frame");
  EXPECT_EQ(counted(1200, "frame"), "1,200 frames");
}

}  // namespace
}  // namespace pelt::text

#include "text/printable.hpp"

#include <gtest/gtest.h>

namespace pelt::test {
namespace {

using text::printable;
using text::printable_name;

TEST(Printable, KeepsWordsOfAllLanguages) {
  for (const char* text :
       {"", "knight/hand_r", "Grüße", "中文", "пешка", "🤺", "می‌خواهم"})
    EXPECT_EQ(printable(text), text);
}

TEST(Printable, ReplacesWhatATerminalObeys) {
  EXPECT_EQ(printable("a\x1b[31mred\r\n\tb\x7f"), "a?[31mred???b?");
  EXPECT_EQ(printable("\xc2\x9b"
                      "31m"),
            "?31m");  // C1: CSI
  EXPECT_EQ(printable("a\xe2\x80\xae"
                      "b\xe2\x81\xa6"
                      "c\xd8\x9c"
                      "d"),
            "a?b?c?d");  // directions
  EXPECT_EQ(printable("a\xe2\x80\xa8"
                      "b\xe2\x80\x8f"),
            "a?b?");  // line end, direction
  EXPECT_EQ(printable(std::string_view("a\0b", 3)), "a?b");
}

TEST(Printable, ReplacesEachByteThatIsNotUtf8) {
  EXPECT_EQ(printable("\x9b"
                      "31m"),
            "?31m");                                 // C1 without UTF-8
  EXPECT_EQ(printable("caf\xe9 au"), "caf? au");     // Latin-1
  EXPECT_EQ(printable("\xc0\x9b"), "??");            // longer form of an ASCII character
  EXPECT_EQ(printable("\xe0\x82\x9b"), "???");       // longer form of a C1 character
  EXPECT_EQ(printable("\xed\xa0\x80"), "???");       // half of a surrogate pair
  EXPECT_EQ(printable("\xf4\x90\x80\x80"), "????");  // beyond Unicode
  EXPECT_EQ(printable("a\xe2\x80"), "a??");          // cut short
}

TEST(Printable, MakesUtf8OfBytes) {
  EXPECT_EQ(text::as_utf8("Grüße\x1b"), "Grüße\x1b");
  EXPECT_EQ(text::as_utf8("a\xff"
                          "b\xe2\x80"),
            "a\xEF\xBF\xBD"
            "b\xEF\xBF\xBD\xEF\xBF\xBD");
}

TEST(Printable, CutsNamesAfterAWholeCodePoint) {
  const std::string longest(text::kLongestName, 'a');
  EXPECT_EQ(printable_name(longest), longest);
  EXPECT_EQ(printable_name(longest + "b"), longest + "...");
  std::string accents;
  for (int i = 0; i < 100; ++i) accents += "é";
  EXPECT_EQ(printable_name("a" + accents), "a" + accents.substr(0, 62) + "...");
  EXPECT_EQ(printable_name(accents), accents.substr(0, 64) + "...");
}

}  // namespace
}  // namespace pelt::test

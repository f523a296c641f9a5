#include "evaluation/reproduce/html.hpp"

#include "evaluation/reproduce/report.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace pelt::reproduce {
namespace {

std::vector<std::string> column(const std::vector<double>& figures) {
  const ColumnFormat format(figures);
  std::vector<std::string> all;
  for (const double figure : figures) all.push_back(format.shown(figure));
  return all;
}

using Texts = std::vector<std::string>;

TEST(ColumnFormat, WritesWholeNumbersInFull) {
  EXPECT_EQ(column({0, 7, 26756, -1234}), Texts({"0", "7", "26,756", "-1,234"}));
  EXPECT_EQ(column({}), Texts());
}

TEST(ColumnFormat, WritesAFewDecimalsInEveryRow) {
  EXPECT_EQ(column({3, 1.2, 0.45, 0}), Texts({"3.00", "1.20", "0.45", "0.00"}));
  EXPECT_EQ(column({0.3, 1}), Texts({"0.3", "1.0"}));
}

TEST(ColumnFormat, AlignsWhatLiesWithinADecade) {
  EXPECT_EQ(column({30.8812, 32, 27.66}), Texts({"30.9", "32.0", "27.7"}));
  EXPECT_EQ(column({0.99371, 1, 1.7618}), Texts({"0.994", "1.000", "1.762"}));
}

TEST(ColumnFormat, KeepsThreeDigitsOfWhatDiffersMore) {
  EXPECT_EQ(column({0.0181818, 4.9, 32, 123.456, 26756.2, 0}),
            Texts({"0.0182", "4.90", "32.0", "123", "26,756", "0"}));
  EXPECT_EQ(column({9.9961, 0.012345, -0.5}), Texts({"10.0", "0.0123", "-0.500"}));
}

TEST(WithMicroSigns, TouchesUnitsOnly) {
  EXPECT_EQ(with_micro_signs("query [us], 12.5 us; us, 3 users, bus [uses]"),
            "query [\u00b5s], 12.5 \u00b5s; us, 3 users, bus [uses]");
  EXPECT_EQ(with_micro_signs("us"), "us");
  EXPECT_EQ(with_micro_signs("4 us"), "4 \u00b5s");
}

}  // namespace
}  // namespace pelt::reproduce

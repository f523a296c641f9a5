#include "evaluation/reproduce/drawing.hpp"

#include <gtest/gtest.h>

#include <cstdio>
#include <vector>

namespace pelt::reproduce {
namespace {

bool has(const std::string& text, const std::string& what) { return text.find(what) != text.npos; }

struct Range {
  double low = 0, high = 0;
};

Range range_of(const std::string& commands) {
  Range range;
  const std::size_t at = commands.find("range [");
  EXPECT_EQ(std::sscanf(commands.c_str() + at, "range [%lf:%lf]", &range.low, &range.high), 2)
      << commands;
  return range;
}

TEST(LogarithmicAxis, IsLittleLongerThanItsFigures) {
  const Range range = range_of(logarithmic_axis("y", std::vector<double>{0, 2.5, 640, 90}));
  EXPECT_LT(range.low, 2.5);
  EXPECT_GT(range.low, 1.5);
  EXPECT_GT(range.high, 640);
  EXPECT_LT(range.high, 1000);
}

TEST(LogarithmicAxis, HasLabelsHoweverShortItIs) {
  const std::string decades = logarithmic_axis("x", std::vector<double>{1000, 1e6});
  EXPECT_TRUE(has(decades, "'1,000' 1000 0")) << decades;
  EXPECT_TRUE(has(decades, "'1,000,000' 1e+06 0")) << decades;
  EXPECT_TRUE(has(decades, "'' 2000 1")) << decades;
  const std::string one = logarithmic_axis("x", std::vector<double>{0.04, 0.9});
  EXPECT_TRUE(has(one, "'0.05' 0.05 0") && has(one, "'0.2' 0.2 0") && has(one, "'' 0.3 1")) << one;
  const std::string less = logarithmic_axis("x", std::vector<double>{20, 64});
  EXPECT_TRUE(has(less, "'30' 30 0") && has(less, "'60' 60 0")) << less;
}

TEST(LogarithmicAxis, BearsWhatHasNoLogarithm) {
  EXPECT_EQ(logarithmic_axis("y", std::vector<double>{0, -1}), "set logscale y\n");
  const Range range = range_of(logarithmic_axis("y", std::vector<double>{5, 5}));
  EXPECT_LT(range.low, range.high);
}

TEST(LinearAxis, IsLittleLongerThanItsFigures) {
  const Range range = range_of(linear_axis("x", std::vector<double>{3, 0, 1}));
  EXPECT_LT(range.low, 0);
  EXPECT_GT(range.low, -0.2);
  EXPECT_GT(range.high, 3);
  EXPECT_LT(range.high, 3.2);
  const Range point = range_of(linear_axis("x", std::vector<double>{2, 2}));
  EXPECT_LT(point.low, point.high);
  EXPECT_EQ(linear_axis("x", {}), "");
}

}  // namespace
}  // namespace pelt::reproduce

#include "tools/pelt/output/statistics.hpp"

#include <gtest/gtest.h>

#include <numeric>
#include <vector>

namespace pelt::tools::output {
namespace {

TEST(Statistics, OfOddAndEvenNumbers) {
  EXPECT_EQ(median(std::vector<double>{3, 1, 2}), 2);
  EXPECT_EQ(median(std::vector<double>{4, 1, 3, 2}), 2);
  EXPECT_EQ(mean(std::vector<double>{4, 1, 3, 2}), 2.5);
}

TEST(Statistics, PercentileIsReachedByThatShare) {
  std::vector<double> values(100);
  std::iota(values.rbegin(), values.rend(), 1.0);
  EXPECT_EQ(percentile(values, 0.95), 95);
  EXPECT_EQ(percentile(values, 1), 100);
  EXPECT_EQ(percentile(values, 0.001), 1);
}

TEST(Statistics, OfNothingAreZero) {
  EXPECT_EQ(median({}), 0);
  EXPECT_EQ(mean({}), 0);
  EXPECT_EQ(percentile({}, 0.95), 0);
}

}  // namespace
}  // namespace pelt::tools::output

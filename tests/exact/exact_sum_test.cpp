#include "exact/exact_determinant.hpp"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iostream>
#include <random>
#include <vector>

namespace pelt::test {
namespace {

/// The largest sum that the predicates use.
using Sum = detail::ExactSum<48>;

/// The value in units of 2^-500.
mpz_class exact(double value) {
  mpq_class quotient(value);
  quotient <<= 500;
  EXPECT_EQ(quotient.get_den(), 1);
  return quotient.get_num();
}

/// Expects the terms to be a nonoverlapping expansion of `expected`.
void expect_sum(const Sum& sum, const mpz_class& expected) {
  mpz_class total, all_before;
  for (const double term : sum.terms()) {
    ASSERT_NE(term, 0);
    const mpz_class magnitude = exact(std::fabs(term));
    ASSERT_LT(all_before, mpz_class(1) << mpz_scan1(magnitude.get_mpz_t(), 0)) << "terms overlap";
    all_before = magnitude;
    total += exact(term);
  }
  ASSERT_EQ(total, expected);
  ASSERT_EQ(sum.sign(), sgn(expected));
}

void expect_exact(const std::vector<double>& values, std::size_t& most_terms) {
  Sum sum;
  mpz_class expected;
  for (const double value : values) {
    sum.add(value);
    expected += exact(value);
    expect_sum(sum, expected);
    if (testing::Test::HasFatalFailure()) return;
    most_terms = std::max(most_terms, sum.terms().size());
  }
}

TEST(ExactSum, OfNothingIsZero) {
  Sum sum;
  expect_sum(sum, 0);
  sum.add(0.0);
  sum.add(-0.0);
  expect_sum(sum, 0);
}

TEST(ExactSum, SeesWhatCancellationLeaves) {
  Sum sum;
  for (const double value : {1.0, 0x1p900, 0x1p300, -0x1p900, -0x1p300}) sum.add(value);
  expect_sum(sum, exact(1));
  sum.add(-1);
  expect_sum(sum, 0);
}

/// Terms 60 bits apart stay separate. A value that extends from just above one term to just below
/// the next leaves its lower bit between them.
TEST(ExactSum, HasRoomForAsManyTermsAsValues) {
  std::vector<double> values;
  for (const double value : {0x1p0, 0x1p56 + 0x1p4})
    for (int i = -8; i < 16; ++i) values.push_back(std::ldexp(value, 60 * i));
  std::size_t most_terms = 0;
  expect_exact(values, most_terms);
  EXPECT_EQ(values.size(), 48u);
  EXPECT_EQ(most_terms, 48u);
}

/// Often has few bits, so that sums have gaps.
double sparse_number(std::mt19937_64& random, int largest_exponent) {
  std::uint64_t mantissa = random() >> 11;
  for (std::uint64_t thinned = random() % 5; thinned > 0; --thinned) mantissa &= random();
  const int exponent = static_cast<int>(random() % static_cast<unsigned>(largest_exponent));
  return std::ldexp(static_cast<double>(mantissa), exponent) * (random() % 2 ? 1 : -1);
}

TEST(ExactSum, IsExactForNumbersOfAllSizes) {
  constexpr std::uint64_t kSeed = 26;
  std::cout << "seed " << kSeed << "\n";
  std::mt19937_64 random(kSeed);
  std::size_t most_terms = 0;
  for (int i = 0; i < 2000; ++i) {
    std::vector<double> values(48);
    for (double& value : values) value = sparse_number(random, i % 2 ? 900 : 120);
    std::copy_n(values.begin(), i % 24, values.end() - i % 24);
    for (int k = 0; k < i % 24; ++k) values[47 - k] = -values[47 - k];  // these cancel
    expect_exact(values, most_terms);
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(most_terms, 20u);
}

}  // namespace
}  // namespace pelt::test

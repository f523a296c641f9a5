#include "exact/big_integer.hpp"
#include "exact/exact_determinant.hpp"
#include "exact/gmp_integers.hpp"
#include "geometry/triangle_cases.hpp"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace pelt::test {
namespace {

using Integer = detail::BigInteger<1'000>;

/// Expects the value, and that the number agrees about its sign and size.
void expect_equal(const Integer& number, const mpz_class& expected) {
  ASSERT_EQ(to_gmp(number), expected);
  ASSERT_EQ(number.sign(), sgn(expected));
  ASSERT_EQ(number.bits(), bits_of(expected));
  if (expected == 0) return;
  ASSERT_EQ(number.trailing_zeros(), mpz_scan1(expected.get_mpz_t(), 0));
}

/// Up to `bits` bits, often with long runs of equal bits, which make carries and borrows travel.
Integer number_of(Random& random, unsigned bits) {
  Integer result;
  while (result.bits() + 33 < bits && random() % 16 != 0) {
    result <<= static_cast<unsigned>(random() % 33);
    const std::uint64_t limb = random() % 3 == 0 ? 0xFFFFFFFF : random() % 2 ? random() >> 32 : 1;
    result += Integer(static_cast<std::int64_t>(limb));
  }
  if (random() % 2) result.negate();
  return result;
}

TEST(BigInteger, HasTheValuesOfSmallIntegers) {
  for (const std::int64_t value :
       {std::int64_t{0}, std::int64_t{1}, std::int64_t{-1}, std::int64_t{1} << 32,
        -(std::int64_t{1} << 40), std::numeric_limits<std::int64_t>::max(),
        std::numeric_limits<std::int64_t>::min()})
    expect_equal(Integer(value), mpz_class(std::to_string(value)));
}

TEST(BigInteger, ComputesAsGmp) {
  Random random = seeded(171);
  unsigned most_bits = 0;
  int zeros = 0;
  for (int i = 0; i < 20'000 && !HasFatalFailure(); ++i) {
    const Integer a = number_of(random, 480);
    const Integer b = random() % 8 == 0 ? a : random() % 8 == 0 ? -a : number_of(random, 480);
    const mpz_class x = to_gmp(a), y = to_gmp(b);
    const auto count = static_cast<unsigned>(random() % 500);
    expect_equal(a + b, x + y);
    expect_equal(a - b, x - y);
    expect_equal(a * b, x * y);
    expect_equal(-a, -x);
    expect_equal(a << count, x << count);
    Integer shifted = a;
    expect_equal(shifted >>= count, sgn(x) * (abs(x) >> count));
    Integer itself = a;
    expect_equal(itself += itself, 2 * x);
    const Integer& same = itself;
    expect_equal(itself -= same, 0);
    if (b.sign() != 0) {
      Integer quotient = a * b;
      quotient.divide_exactly(b);
      expect_equal(quotient, x);
    }
    most_bits = std::max(most_bits, (a * b).bits());
    zeros += (a - b).sign() == 0;
  }
  EXPECT_GT(most_bits, 800u);
  EXPECT_GT(zeros, 1'000);
}

TEST(BigInteger, MultipliesIntoAnotherCapacity) {
  detail::BigInteger<200> a(1), b(-1);
  a <<= 150;
  b <<= 199;
  Integer product;
  product.assign_product(a, b);
  expect_equal(product, -(mpz_class(1) << 349));
  expect_equal(Integer(b), -(mpz_class(1) << 199));
}

TEST(BigInteger, RoundsToADouble) {
  Random random = seeded(172);
  for (int i = 0; i < 20'000; ++i) {
    const Integer a = number_of(random, 960);
    const mpz_class x = to_gmp(a);
    const mpq_class error = abs(mpq_class(rounded(a)) - x);
    ASSERT_LE(error * (mpz_class(1) << 52), abs(x));
    if (a.bits() <= 53) {
      ASSERT_EQ(error, 0);
    }
  }
  EXPECT_EQ(rounded(Integer()), 0);
}

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
  Random random = seeded(26);
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

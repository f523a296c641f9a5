#include "exact/big_integer.hpp"

#include "gmp_integers.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <iostream>
#include <limits>
#include <random>

namespace pelt::test {
namespace {

using Integer = detail::BigInteger<1'000>;
using Random = std::mt19937_64;

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
  constexpr std::uint64_t kSeed = 171;
  std::cout << "seed " << kSeed << "\n";
  Random random(kSeed);
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
  constexpr std::uint64_t kSeed = 172;
  std::cout << "seed " << kSeed << "\n";
  Random random(kSeed);
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

}  // namespace
}  // namespace pelt::test

/// Roots and signs at roots against the polynomials' factors, and against numbers of GMP.
#include "exact/critical_time.hpp"

#include "exact/predicates.hpp"
#include "gmp_integers.hpp"
#include "motion/moving_oracle.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iostream>
#include <random>
#include <vector>

namespace pelt::test {
namespace {

using detail::CriticalTime;
using detail::CriticalTimes;
using detail::Cubic;
using detail::RootOf;
using detail::RootsOf;
using detail::Sextic;
using Random = std::mt19937_64;

std::int64_t uniform(Random& random, std::int64_t low, std::int64_t high) {
  return std::uniform_int_distribution<std::int64_t>(low, high)(random);
}

template <typename P>
P polynomial(const IntegerPolynomial& p) {
  P result;
  for (std::size_t i = 0; i < p.size(); ++i)
    result.coefficients[i] = from_gmp<typename P::Coefficient>(p[i]);
  return result;
}

Cubic cubic(const IntegerPolynomial& p) { return polynomial<Cubic>(p); }

mpz_class random_integer(Random& random, unsigned bits) {
  mpz_class result;
  for (unsigned i = 0; i < bits; i += 32) result = (result << 32) + mpz_class(random() >> 32);
  result >>= (bits + 31) / 32 * 32 - bits;
  return random() % 2 ? mpz_class(-result) : result;
}

/// Bits of coefficients, without the room for sums.
template <typename P>
constexpr unsigned kInputBits = 0;
template <>
constexpr unsigned kInputBits<Cubic> = detail::kCoefficientBits;
template <>
constexpr unsigned kInputBits<Sextic> = Sextic::kBits - 30;

/// Factors with small coefficients, so that roots are often equal, or with as many bits as
/// coefficients can have.
template <typename P>
IntegerPolynomial random_polynomial(Random& random) {
  if (random() % 4 == 0) {
    IntegerPolynomial p(1 + random() % (P::kDegree + 1));
    for (mpz_class& c : p) c = random_integer(random, kInputBits<P>);
    trim(p);
    return p;
  }
  IntegerPolynomial p = {uniform(random, -2, 2)};
  trim(p);
  for (auto factors = random() % (P::kDegree + 1); factors > 0; --factors)
    p = p * IntegerPolynomial{-uniform(random, 0, 8), uniform(random, 1, 8)};
  return p;
}

/// Two roots closer to each other than the distance of doubles, and sometimes equal.
IntegerPolynomial with_close_roots(Random& random) {
  const mpz_class big = mpz_class(1) << 200;
  const mpz_class root = abs(random_integer(random, 199)), gap = uniform(random, 0, 1);
  return IntegerPolynomial{-root, big} * IntegerPolynomial{-root - gap, big} *
         IntegerPolynomial{uniform(random, -3, 3), uniform(random, 1, 4)};
}

bool is_before_one(OracleTime& time) {
  OracleTime one({-1, 1}, 1, 0, true);
  return time.compare(one) < 0;
}

/// Distinct roots in (0, 1), ascending.
std::vector<OracleTime> inner_roots(const IntegerPolynomial& p) {
  std::vector<OracleTime> all, inner;
  OracleRoots::append(p, all);
  for (OracleTime& time : all)
    if (is_before_one(time)) inner.push_back(time);
  std::sort(inner.begin(), inner.end(), [](const OracleTime& a, const OracleTime& b) {
    OracleTime x = a, y = b;
    return x.compare(y) < 0;
  });
  return inner;
}

/// Critical times that are roots, ascending.
template <typename P>
std::vector<RootOf<P>> roots_of(const P& p) {
  RootsOf<P> found;
  find_critical_times(p, found);
  std::vector<RootOf<P>> roots;
  for (std::size_t i = 0; i < found.count; ++i) {
    const int sign = found.entries[i].time.sign_of(p);
    EXPECT_TRUE(sign == 0 || !found.entries[i].is_root);
    if (sign == 0) roots.push_back(found.entries[i].time);
  }
  std::sort(roots.begin(), roots.end(),
            [](const RootOf<P>& a, const RootOf<P>& b) { return a.compare(b) < 0; });
  return roots;
}

struct Counts {
  int roots = 0, zeros = 0, equal = 0;
};

template <typename P>
void compare(const IntegerPolynomial& f, const IntegerPolynomial& g, Counts& counts) {
  std::vector<OracleTime> expected = inner_roots(f), others = inner_roots(g);
  const P exact_f = polynomial<P>(f), exact_g = polynomial<P>(g);
  const std::vector<RootOf<P>> roots = roots_of(exact_f), other_roots = roots_of(exact_g);
  ASSERT_EQ(roots.size(), expected.size());
  ASSERT_EQ(other_roots.size(), others.size());
  for (std::size_t i = 0; i < roots.size(); ++i) {
    ASSERT_EQ(roots[i].sign_of(exact_g), expected[i].sign_of(g));
    ASSERT_EQ(roots[i].rounded_down(), expected[i].rounded_down());
    counts.zeros += expected[i].sign_of(g) == 0;
    for (std::size_t k = 0; k < others.size(); ++k) {
      ASSERT_EQ(roots[i].compare(other_roots[k]), expected[i].compare(others[k]));
      counts.equal += expected[i].compare(others[k]) == 0;
    }
  }
  counts.roots += static_cast<int>(roots.size());
}

/// A polynomial to compare with f: any, the derivative, or f plus or minus 1, whose signs at the
/// roots of f rounded numbers often cannot decide.
IntegerPolynomial to_compare_with(const IntegerPolynomial& f, IntegerPolynomial (*make)(Random&),
                                  Random& random) {
  const auto choice = random() % 8;
  if (choice == 0) return derivative(f);
  if (choice == 1) return f - IntegerPolynomial{1};
  if (choice == 2) return f - IntegerPolynomial{-1};
  return make(random);
}

template <typename P>
void compare_many(IntegerPolynomial (*make)(Random&), std::uint64_t seed, int pairs) {
  std::cout << "seed " << seed << ": ";
  Random random(seed);
  Counts counts;
  for (int i = 0; i < pairs && !testing::Test::HasFailure(); ++i) {
    const IntegerPolynomial f = make(random);
    SCOPED_TRACE(i);
    compare<P>(f, to_compare_with(f, make, random), counts);
  }
  EXPECT_GT(counts.roots, 500);
  EXPECT_GT(counts.zeros, 20);
  EXPECT_GT(counts.equal, 20);
}

TEST(CriticalTime, HasTheSignsOfPolynomialsWithSmallFactorsOrManyBits) {
  compare_many<Cubic>(random_polynomial<Cubic>, 173, 10'000);
}

TEST(CriticalTime, TellsApartRootsThatAreCloserThanDoubles) {
  compare_many<Cubic>(with_close_roots, 174, 450);
}

TEST(CriticalTime, HasTheSignsOfPolynomialsOfDegreeSix) {
  compare_many<Sextic>(random_polynomial<Sextic>, 175, 1'000);
}

TEST(CriticalTime, ComparesWithDyadicTimes) {
  CriticalTimes found;
  find_critical_times(cubic({-1, 3}), found);
  ASSERT_EQ(found.count, 1u);
  const CriticalTime third = found.entries[0].time;
  EXPECT_EQ(third.compare(detail::dyadic(0)), 1);
  EXPECT_EQ(third.compare(detail::dyadic(1)), -1);
  EXPECT_EQ(third.compare(detail::dyadic(1.0 / 3)), 1);  // the double is below a third
  EXPECT_EQ(third.compare(detail::dyadic(std::nextafter(1.0 / 3, 1))), -1);
  find_critical_times(cubic({-1, 4}), found);
  EXPECT_EQ(found.entries[0].time.compare(detail::dyadic(0.25)), 0);
  EXPECT_EQ(found.entries[0].time.rounded_down(), 0.25f);
}

TEST(CriticalTime, RoundsDownTimesBelowTheSmallestFloat) {
  CriticalTimes found;
  find_critical_times(cubic({-1, mpz_class(1) << 200}), found);
  ASSERT_EQ(found.count, 1u);
  EXPECT_EQ(found.entries[0].time.rounded_down(), 0);
  find_critical_times(cubic({-3, mpz_class(1) << 149}), found);
  EXPECT_EQ(found.entries[0].time.rounded_down(), 3 * 0x1p-149f);
}

TEST(CriticalTime, DoesNotExistForConstantsAndAtTheEnds) {
  CriticalTimes found;
  for (const IntegerPolynomial& p :
       {IntegerPolynomial{}, {7}, {0, 0, 0, 5}, {-1, 3, -3, 1}, {0, -1, 1}, {0, 1, -2, 1}}) {
    find_critical_times(cubic(p), found);
    EXPECT_EQ(found.count, 0u);
  }
}

}  // namespace
}  // namespace pelt::test

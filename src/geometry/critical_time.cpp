/// Signs at a root are computed by the theorem of Sturm and Tarski. For polynomials f and g, let
/// S_0 = f, S_1 = f' g mod f, S_{i+1} = -(S_{i-1} mod S_i), and let V(x) be the number of sign
/// changes in the sequence of the values S_i(x), without zeros. If neither f(l) nor f(r) is zero,
/// V(l) - V(r) is the sum of the signs of g at the distinct roots of f in (l, r). With g = 1, this
/// is the number of roots. With one root in (l, r), it is the sign of g at this root. Roots of f
/// may be multiple. A positive multiple of a remainder serves as well as the remainder, so nothing
/// is divided: before each step of a division, the dividend is multiplied by the absolute value of
/// the divisor's leading coefficient.
///
/// Bits. Let L be the number of bits of the coefficients of f and g, both of degree 3.
///
///   polynomial   degree   bits
///   f'           2        L + 2
///   f' g         5        2 L + 4     each coefficient is a sum of at most three products
///   S_1          2        5 L + 7     three steps; each multiplies by L bits and adds: L + 1 more
///   S_2          1        11 L + 16   two steps: 2 (5 L + 8) more than S_0
///   S_3          0        27 L + 41   two steps: 2 (11 L + 17) more than S_1
///
/// If S_1 has degree 1, S_2 is a constant of at most L + 3 (5 L + 8) bits. L is at most
/// kCoefficientBits + 3 = 649 (below), which gives 17,564 bits.
///
/// Ends of intervals. Two roots of an integer polynomial with degree n = 3 and coefficients of L
/// bits are farther apart than sqrt(3) n^(-(n + 2) / 2) sqrt(D) |f|^(1 - n) (Mahler 1964), with a
/// discriminant D of at least 1 and a norm |f| of at most 2^(L + 1): farther than 2^-(2 L + 6). For
/// f with a multiple root, all roots are rational; two of them have a difference with a denominator
/// below 2^(2 L). Bisection therefore ends at a width of 2^-(2 L + 7) or before. A step halves the
/// interval, unless f or f' vanishes at its middle. This happens at most five times, and adds four
/// bits instead of one. Ends thus have at most 2 L + 40 bits. The values of S_1 at them have at
/// most 5 L + 7 + 2 (2 L + 40) + 2 bits, those of f at most L + 3 (2 L + 40) + 2: both are less
/// than S_3 can have.
///
/// Derivatives and quotients. The coefficients of the quotients of f by t - 1 are sums of
/// coefficients of f, at most three each, and a derivative multiplies them by 3 or less; a quotient
/// of degree 2 has sums of at most three, of which a derivative takes two at most twice. The
/// factors in all are at most 6: three bits.
#include "geometry/critical_time.hpp"

#include "base/bits.hpp"
#include "geometry/exact_number.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>

namespace pelt::detail {
namespace {

/// Room for all that the head of this file counts.
using Wide = BigInteger<18'432>;

/// Bits of a time for which a double is exact.
constexpr unsigned kDoubleBits = 52;

template <typename Integer, std::size_t kSize>
int degree(const std::array<Integer, kSize>& coefficients) {
  int result = static_cast<int>(kSize) - 1;
  while (result >= 0 && coefficients[static_cast<std::size_t>(result)].sign() == 0) --result;
  return result;
}

/// The sign of a polynomial by Horner's rule: of the sum of coefficients[i] m^i 2^(k (n - i)) for
/// the time m / 2^k.
template <typename Integer, std::size_t kSize>
int horner_sign(const std::array<Integer, kSize>& coefficients, const Dyadic& time) {
  int i = degree(coefficients);
  if (i < 0) return 0;
  Wide sum(coefficients[static_cast<std::size_t>(i)]), product;
  for (unsigned shift = time.exponent; i-- > 0; shift += time.exponent) {
    product.assign_product(sum, time.numerator);
    sum = Wide(coefficients[static_cast<std::size_t>(i)]);
    sum <<= shift;
    sum += product;
  }
  return sum.sign();
}

/// Divides by the largest common power of two.
template <std::size_t kSize>
void shorten(std::array<Wide, kSize>& coefficients) {
  unsigned common = ~0u;
  for (const Wide& c : coefficients)
    if (c.sign() != 0) common = std::min(common, c.trailing_zeros());
  if (common == 0 || common == ~0u) return;
  for (Wide& c : coefficients) c >>= common;
}

/// Replaces `dividend` by a positive multiple of its remainder.
template <std::size_t kDividend, typename Integer, std::size_t kDivisor>
void reduce(std::array<Wide, kDividend>& dividend, const std::array<Integer, kDivisor>& divisor) {
  const int of_divisor = degree(divisor);
  const auto n = static_cast<std::size_t>(of_divisor);
  Wide positive(divisor[n]);
  if (positive.sign() < 0) positive.negate();
  for (int d = degree(dividend); d >= of_divisor; d = degree(dividend)) {
    const auto lead = static_cast<std::size_t>(d), shift = lead - n;
    Wide factor = dividend[lead], product;
    if (divisor[n].sign() > 0) factor.negate();
    for (std::size_t i = 0; i < lead; ++i) {
      product.assign_product(dividend[i], positive);
      dividend[i] = product;
      if (i < shift) continue;
      product.assign_product(divisor[i - shift], factor);
      dividend[i] += product;
    }
    dividend[lead] = Wide();
  }
}

/// The sequence of Sturm and Tarski of two polynomials.
class SignSequence {
 public:
  SignSequence(const Cubic& f, const Cubic& g) : first_(f.coefficients) {
    std::array<Wide, 6> product = derivative_times(g);
    reduce(product, first_);
    std::copy_n(product.begin(), second_.size(), second_.begin());
    shorten(second_);
    if (degree(second_) < 1) return;
    std::array<Wide, 4> rest;
    for (std::size_t i = 0; i < 4; ++i) rest[i] = Wide(first_[i]);
    reduce(rest, second_);
    for (std::size_t i = 0; i < third_.size(); ++i) third_[i] = -rest[i];
    shorten(third_);
    if (degree(third_) < 1) return;
    std::array<Wide, 3> last = second_;
    reduce(last, third_);
    sign_of_fourth_ = -last[0].sign();
  }

  /// Returns the sum of the signs of g at the roots of f in the open interval. Precondition: f is
  /// not zero at its ends.
  int sum_between(const Dyadic& low, const Dyadic& high) const {
    return changes_at(low) - changes_at(high);
  }

 private:
  std::array<Wide, 6> derivative_times(const Cubic& g) const {
    std::array<Wide, 6> product;
    Wide term;
    for (std::size_t i = 1; i < 4; ++i) {
      Wide slope;
      slope.assign_product(first_[i], Wide(static_cast<std::int64_t>(i)));
      for (std::size_t k = 0; k < 4; ++k) {
        term.assign_product(slope, g.coefficients[k]);
        product[i - 1 + k] += term;
      }
    }
    return product;
  }

  int changes_at(const Dyadic& time) const {
    int changes = 0, previous = 0;
    for (const int sign : {horner_sign(first_, time), horner_sign(second_, time),
                           horner_sign(third_, time), sign_of_fourth_}) {
      if (sign == 0) continue;
      changes += previous == -sign;
      previous = sign;
    }
    return changes;
  }

  const std::array<Coefficient, 4>& first_;
  std::array<Wide, 3> second_;
  std::array<Wide, 2> third_;
  int sign_of_fourth_ = 0;
};

/// Divides by t as often as possible, and by t - 1. Precondition: p is not zero.
void divide_out_ends(Cubic& p) {
  auto& c = p.coefficients;
  while (c[0].sign() == 0) {
    for (std::size_t i = 0; i < 3; ++i) c[i] = c[i + 1];
    c[3] = Coefficient();
  }
  while ((c[0] + c[1] + c[2] + c[3]).sign() == 0) {
    c[2] += c[3];
    c[1] += c[2];
    for (std::size_t i = 0; i < 3; ++i) c[i] = c[i + 1];
    c[3] = Coefficient();
  }
}

/// Number of sign changes in the coefficients of p in the basis of Bernstein on [0, 1]. It is at
/// least the number of roots in between, counted with multiplicity, and has the same parity.
int bernstein_changes(const Cubic& p) {
  const auto& [c0, c1, c2, c3] = p.coefficients;
  const Coefficient second = c0 + c0 + c0 + c1, third = second + c1 + c2;
  const int signs[4] = {c0.sign(), second.sign(), third.sign(), (c0 + c1 + c2 + c3).sign()};
  int changes = 0, previous = 0;
  for (const int sign : signs) {
    if (sign == 0) continue;
    changes += previous == -sign;
    previous = sign;
  }
  return changes;
}

/// Returns low + (high - low) sixteenths / 16.
Dyadic between(const Dyadic& low, const Dyadic& high, unsigned sixteenths) {
  Dyadic result, end = high;
  result.exponent = std::max(low.exponent, high.exponent);
  result.numerator = low.numerator;
  result.numerator <<= result.exponent - low.exponent;
  end.numerator <<= result.exponent - high.exponent;
  end.numerator -= result.numerator;
  const unsigned halvings = sixteenths == 8 ? 1 : 4;
  decltype(end.numerator) part;
  part.assign_product(end.numerator,
                      decltype(end.numerator)(halvings == 1 ? 1 : std::int64_t{sixteenths}));
  result.numerator <<= halvings;
  result.numerator += part;
  result.exponent += halvings;
  return result;
}

/// Finds disjoint intervals with one root each.
class Isolation {
 public:
  explicit Isolation(CriticalTimes& found) : found_(found) {}

  /// Precondition: p is zero neither at 0 nor at 1.
  void search(const Cubic& p) {
    const int changes = bernstein_changes(p);
    if (changes == 0) return;
    const Dyadic start = dyadic(0), end = dyadic(1);
    if (changes == 1) return add(p, start, end, true);
    search(p, start, end, true);
  }

 private:
  void search(const Cubic& p, const Dyadic& low, const Dyadic& high, bool is_root) {
    Cubic one;
    one.coefficients[0] = Coefficient(1);
    const SignSequence roots(p, one);
    search(p, roots, low, high, is_root);
  }

  void search(const Cubic& p, const SignSequence& roots, Dyadic low, Dyadic high, bool is_root) {
    int count = roots.sum_between(low, high);
    while (count > 1) {
      const Dyadic middle = point_without_zeros(p, low, high);
      const int below = roots.sum_between(low, middle);
      if (below > 0 && below < count) search(p, roots, low, middle, is_root);
      (below == count ? high : low) = middle;
      if (below != count) count -= below;
    }
    if (count == 0) return;
    if (sign_at(p, low) != sign_at(p, high)) return add(p, low, high, is_root);
    Cubic slope = derivative(p);
    divide_out_ends(slope);
    search(slope, low, high, false);
  }

  /// A point near the middle of an interval at which neither p nor its derivative is zero.
  static Dyadic point_without_zeros(const Cubic& p, const Dyadic& low, const Dyadic& high) {
    const Cubic slope = derivative(p);
    for (const unsigned sixteenths : {8u, 7u, 9u, 6u, 10u}) {
      const Dyadic point = between(low, high, sixteenths);
      if (sign_at(p, point) != 0 && sign_at(slope, point) != 0) return point;
    }
    return between(low, high, 5);  // five zeros were found, and there are no more
  }

  void add(const Cubic& p, const Dyadic& low, const Dyadic& high, bool is_root) {
    PELT_ASSERT(found_.count < found_.entries.size());
    found_.entries[found_.count++] = {CriticalTime(p, low, high), is_root};
  }

  CriticalTimes& found_;
};

std::array<Rounded, 4> rounded_coefficients(const Cubic& p) {
  const auto coefficient = [&](std::size_t i) {
    const double value = rounded(p.coefficients[i]);
    return Rounded::within(value, 0x1p-52 * std::abs(value));
  };
  return {coefficient(0), coefficient(1), coefficient(2), coefficient(3)};
}

Rounded value_at(const std::array<Rounded, 4>& c, const Rounded& time) {
  return ((c[3] * time + c[2]) * time + c[1]) * time + c[0];
}

/// Returns -1, 0 or 1 if a is less than, equal to or greater than b.
int compare_numbers(const Dyadic& a, const Dyadic& b) {
  const unsigned exponent = std::max(a.exponent, b.exponent);
  auto difference = a.numerator, subtrahend = b.numerator;
  difference <<= exponent - a.exponent;
  subtrahend <<= exponent - b.exponent;
  difference -= subtrahend;
  return difference.sign();
}

float float_from(std::uint32_t bits) { return bits_as<float>(bits); }

/// The bits of the largest float that is not above `time`, which is from 0 to 1.
std::uint32_t bits_below(double time) {
  const auto bits = bits_as<std::uint32_t>(static_cast<float>(time));
  return double{float_from(bits)} > time ? bits - 1 : bits;
}

}  // namespace

bool is_zero(const Cubic& p) { return degree(p.coefficients) < 0; }

Dyadic dyadic(double time) {
  PELT_ASSERT(time >= 0 && time <= 1);
  Dyadic result;
  if (time == 0) return result;
  int exponent = 0;
  const double fraction = std::frexp(time, &exponent);
  const auto numerator = static_cast<std::int64_t>(std::ldexp(fraction, 53));
  const int zeros = std::countr_zero(static_cast<std::uint64_t>(numerator));
  result.numerator = decltype(result.numerator)(numerator >> zeros);
  result.exponent = static_cast<unsigned>(53 - exponent - zeros);
  return result;
}

Cubic derivative(const Cubic& p) {
  Cubic result;
  for (std::size_t i = 1; i < 4; ++i)
    result.coefficients[i - 1].assign_product(p.coefficients[i],
                                              Coefficient(static_cast<std::int64_t>(i)));
  return result;
}

int sign_at(const Cubic& p, const Dyadic& time) { return horner_sign(p.coefficients, time); }

CriticalTime::CriticalTime(const Cubic& polynomial, const Dyadic& low, const Dyadic& high)
    : polynomial_(polynomial),
      low_(low),
      high_(high),
      sign_at_low_(detail::sign_at(polynomial, low)) {
  PELT_ASSERT(sign_at_low_ != 0 && detail::sign_at(polynomial, high) == -sign_at_low_);
  const auto number = [](const Dyadic& t) {
    return std::ldexp(rounded(t.numerator), -static_cast<int>(t.exponent));
  };
  above_ = number(low);
  below_ = number(high);
  if (low.exponent <= kDoubleBits && high.exponent <= kDoubleBits) {
    refine();
  } else {
    above_ = std::max(0.0, above_ * (1 - 0x1p-50) - 0x1p-1000);
    below_ = std::min(1.0, below_ * (1 + 0x1p-50) + 0x1p-1000);
  }
}

/// Halves the interval of the bounds while rounded arithmetic decides on which side the root is,
/// and a few times more.
void CriticalTime::refine() {
  const std::array<Rounded, 4> coefficients = rounded_coefficients(polynomial_);
  int exact_signs = 3;
  while (exact_signs > 0) {
    const double middle = above_ + (below_ - above_) / 2;
    if (middle <= above_ || middle >= below_) return;
    std::optional<int> sign = value_at(coefficients, Rounded(middle)).sign();
    if (!sign) {
      --exact_signs;
      sign = detail::sign_at(polynomial_, dyadic(middle));
    }
    if (*sign == 0) {
      above_ = std::nextafter(middle, 0.0);
      below_ = std::nextafter(middle, 1.0);
      return;
    }
    (*sign == sign_at_low_ ? above_ : below_) = middle;
  }
}

int CriticalTime::sign_of(const Cubic& p) const {
  const double radius = (below_ - above_) / 2;
  const Rounded time = Rounded::within(above_ + radius, radius * (1 + 0x1p-50) + 0x1p-53 * below_);
  if (const std::optional<int> sign = value_at(rounded_coefficients(p), time).sign()) return *sign;
  if (is_zero(p)) return 0;
  ++exact_sign_count();
  return SignSequence(polynomial_, p).sum_between(low_, high_);
}

int CriticalTime::compare(const Dyadic& other) const {
  if (compare_numbers(other, low_) <= 0) return 1;
  if (compare_numbers(other, high_) >= 0) return -1;
  const int sign = detail::sign_at(polynomial_, other);
  if (sign == 0) return 0;
  return sign == sign_at_low_ ? 1 : -1;
}

int CriticalTime::compare(const CriticalTime& other) const {
  if (below_ <= other.above_) return -1;
  if (above_ >= other.below_) return 1;
  if (compare(other.low_) <= 0) return -1;
  if (compare(other.high_) >= 0) return 1;
  const int sign = sign_of(other.polynomial_);
  if (sign == 0) return 0;
  return sign == other.sign_at_low_ ? -1 : 1;
}

float CriticalTime::rounded_down() const {
  // The float of `low` is not above the time, the float of `high` is above it.
  std::uint32_t low = bits_below(above_), high = bits_below(below_) + 1;
  while (high - low > 1) {
    const std::uint32_t middle = low + (high - low) / 2;
    (compare(dyadic(double{float_from(middle)})) >= 0 ? low : high) = middle;
  }
  return float_from(low);
}

void find_critical_times(const Cubic& p, CriticalTimes& found) {
  found.count = 0;
  if (is_zero(p)) return;
  Cubic inner = p;
  divide_out_ends(inner);
  Isolation(found).search(inner);
}

}  // namespace pelt::detail

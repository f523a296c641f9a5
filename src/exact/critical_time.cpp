/// Signs at a root are those of a sequence of polynomials (sign_sequence.hpp), unless rounded
/// numbers decide them.
///
/// Ends of intervals. Two roots of an integer polynomial with degree n and coefficients of L bits
/// are farther apart than sqrt(3) n^(-(n + 2) / 2) sqrt(D) |f|^(1 - n) (Mahler 1964), with a
/// discriminant D of at least 1 and a norm |f| of at most 2^(L + 2): farther than 2^-((n - 1) (L +
/// 2) + 11). For f with a multiple root, this holds for its squarefree divisor, which has a lower
/// degree and coefficients of at most 2^n |f|. Bisection therefore ends at a width of half of this
/// or before. A step halves the interval, unless f or f' vanishes at its middle. This happens at
/// most 2 n - 1 times for each of the derivatives of f, and adds four bits instead of one. Ends
/// thus have at most the bits of DyadicOf, E. The values of f at them have at most L + n E + 4
/// bits, those of an element of degree j at most (4 n - 1 - 3 j) (L + 16) + j E + 4: less than the
/// remainders before they are divided.
///
/// Derivatives and quotients. The coefficients of the quotients of f by t - 1 are sums of
/// coefficients of f, at most three each for a cubic, and a derivative multiplies them by 3 or
/// less; a quotient of degree 2 has sums of at most three, of which a derivative takes two at most
/// twice. The factors in all are at most 6: three bits. For degree 6, derivatives multiply by 720
/// at most, and each of at most six quotients sums at most seven coefficients: 28 bits.
#include "exact/critical_time.hpp"

#include "base/bits.hpp"
#include "exact/sign_sequence.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>
#include <utility>

namespace pelt::detail {
namespace {

/// Bits of a time for which a double is exact.
constexpr unsigned kDoubleBits = 52;

/// Divides by t as often as possible, and by t - 1. Precondition: p is not zero.
template <typename P>
void divide_out_ends(P& p) {
  auto& c = p.coefficients;
  const auto shift = [&] {
    for (std::size_t i = 0; i < P::kDegree; ++i) c[i] = c[i + 1];
    c[P::kDegree] = typename P::Coefficient();
  };
  const auto value_at_one = [&] {
    typename P::Coefficient sum;
    for (const auto& coefficient : c) sum += coefficient;
    return sum;
  };
  while (c[0].sign() == 0) shift();
  while (value_at_one().sign() == 0) {
    for (std::size_t i = P::kDegree; i > 1; --i) c[i - 1] += c[i];
    shift();
  }
}

/// Number of sign changes in the coefficients of p in the basis of Bernstein on [0, 1]. It is at
/// least the number of roots in between, counted with multiplicity, and has the same parity.
///
/// Coefficient k, times a binomial, is the sum of binomial(n - i, k - i) p_i. As a polynomial in x,
/// these are the values of (1 + x)^n p(x / (1 + x)), by Horner's rule from the lowest power.
template <typename P>
int bernstein_changes(const P& p) {
  std::array<typename P::Coefficient, P::kDegree + 1> b;
  for (std::size_t i = 0; i <= P::kDegree; ++i) {
    for (std::size_t k = i; k > 0; --k) b[k] += b[k - 1];
    b[i] += p.coefficients[i];
  }
  SignChanges changes;
  for (const auto& coefficient : b) changes.add(coefficient.sign());
  return changes.count();
}

/// Returns low + (high - low) sixteenths / 16.
template <typename Time>
Time between(const Time& low, const Time& high, unsigned sixteenths) {
  Time result, end = high;
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
template <typename P>
class Isolation {
 public:
  explicit Isolation(RootsOf<P>& found) : found_(found) {}

  /// Precondition: p is zero neither at 0 nor at 1.
  void search(const P& p) {
    const int changes = bernstein_changes(p);
    if (changes == 0) return;
    const Time start = dyadic<P>(0), end = dyadic<P>(1);
    if (changes == 1) return add(p, start, end, true);
    search(p, start, end, true);
  }

 private:
  using Time = DyadicOf<P>;
  using Sequence = SignSequence<P>;

  void search(const P& p, const Time& low, const Time& high, bool is_root) {
    P one;
    one.coefficients[0] = typename P::Coefficient(1);
    const Sequence roots(p, one);
    search(p, roots, low, high, is_root);
  }

  void search(const P& p, const Sequence& roots, Time low, Time high, bool is_root) {
    int count = roots.sum_between(low, high);
    while (count > 1) {
      const Time middle = point_without_zeros(p, low, high);
      const int below = roots.sum_between(low, middle);
      if (below > 0 && below < count) search(p, roots, low, middle, is_root);
      (below == count ? high : low) = middle;
      if (below != count) count -= below;
    }
    if (count == 0) return;
    if (sign_at(p, low) != sign_at(p, high)) return add(p, low, high, is_root);
    P slope = derivative(p);
    divide_out_ends(slope);
    search(slope, low, high, false);
  }

  /// A point near the middle of an interval at which neither p nor its derivative is zero.
  /// Together, they have at most 11 zeros.
  static Time point_without_zeros(const P& p, const Time& low, const Time& high) {
    const P slope = derivative(p);
    for (const unsigned sixteenths : {8u, 7u, 9u, 6u, 10u, 5u, 11u, 4u, 12u, 3u, 13u}) {
      const Time point = between(low, high, sixteenths);
      if (sign_at(p, point) != 0 && sign_at(slope, point) != 0) return point;
    }
    return between(low, high, 2);
  }

  void add(const P& p, const Time& low, const Time& high, bool is_root) {
    PELT_ASSERT(found_.count < found_.entries.size());
    found_.entries[found_.count++] = {RootOf<P>(p, low, high), is_root};
  }

  RootsOf<P>& found_;
};

template <typename P>
using RoundedCoefficients = std::array<Rounded, P::kDegree + 1>;

/// A positive multiple of p that does not overflow.
template <typename P, std::size_t... kPowers>
RoundedCoefficients<P> rounded_coefficients(const P& p, std::index_sequence<kPowers...>) {
  constexpr unsigned kMostBits = 900;
  unsigned bits = kMostBits;
  for (const auto& c : p.coefficients) bits = std::max(bits, c.bits());
  const auto coefficient = [&](const auto& c) {
    if (c.sign() == 0) return Rounded(0);
    const double value = rounded(c, bits - kMostBits);
    return Rounded::within(value, 0x1p-52 * std::abs(value) + (bits > kMostBits ? 0x1p-1000 : 0));
  };
  return {coefficient(p.coefficients[kPowers])...};
}

template <typename P>
RoundedCoefficients<P> rounded_coefficients(const P& p) {
  return rounded_coefficients(p, std::make_index_sequence<P::kDegree + 1>());
}

template <std::size_t kCount>
Rounded value_at(const std::array<Rounded, kCount>& c, const Rounded& time) {
  Rounded value = c[kCount - 1];
  for (std::size_t i = kCount - 1; i-- > 0;) value = value * time + c[i];
  return value;
}

/// Returns -1, 0 or 1 if a is less than, equal to or greater than b.
template <typename Time>
int compare_numbers(const Time& a, const Time& b) {
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

template <typename P>
bool is_zero(const P& p) {
  return degree_of(p.coefficients) < 0;
}

template <typename P>
DyadicOf<P> dyadic(double time) {
  PELT_ASSERT(time >= 0 && time <= 1);
  DyadicOf<P> result;
  if (time == 0) return result;
  int exponent = 0;
  const double fraction = std::frexp(time, &exponent);
  const auto numerator = static_cast<std::int64_t>(std::ldexp(fraction, 53));
  const int zeros = std::countr_zero(static_cast<std::uint64_t>(numerator));
  result.numerator = decltype(result.numerator)(numerator >> zeros);
  result.exponent = static_cast<unsigned>(53 - exponent - zeros);
  return result;
}

template <typename P>
P derivative(const P& p) {
  P result;
  for (std::size_t i = 1; i <= P::kDegree; ++i)
    result.coefficients[i - 1].assign_product(
        p.coefficients[i], typename P::Coefficient(static_cast<std::int64_t>(i)));
  return result;
}

template <typename P>
int sign_at(const P& p, const DyadicOf<P>& time) {
  return horner_sign<P>(p.coefficients, time);
}

template <typename P>
RootOf<P>::RootOf(const P& polynomial, const Time& low, const Time& high)
    : polynomial_(polynomial),
      low_(low),
      high_(high),
      sign_at_low_(detail::sign_at(polynomial, low)) {
  PELT_ASSERT(sign_at_low_ != 0 && detail::sign_at(polynomial, high) == -sign_at_low_);
  above_ = rounded(low.numerator, low.exponent);
  below_ = rounded(high.numerator, high.exponent);
  if (low.exponent <= kDoubleBits && high.exponent <= kDoubleBits) {
    refine();
  } else {
    above_ = std::max(0.0, above_ * (1 - 0x1p-50) - 0x1p-1000);
    below_ = std::min(1.0, below_ * (1 + 0x1p-50) + 0x1p-1000);
  }
}

/// Halves the interval of the bounds while rounded arithmetic decides on which side the root is,
/// and a few times more.
template <typename P>
void RootOf<P>::refine() {
  const RoundedCoefficients<P> coefficients = rounded_coefficients(polynomial_);
  int exact_signs = 3;
  while (exact_signs > 0) {
    const double middle = above_ + (below_ - above_) / 2;
    if (middle <= above_ || middle >= below_) return;
    std::optional<int> sign = value_at(coefficients, Rounded(middle)).sign();
    if (!sign) {
      --exact_signs;
      sign = detail::sign_at(polynomial_, dyadic<P>(middle));
    }
    if (*sign == 0) {
      above_ = std::nextafter(middle, 0.0);
      below_ = std::nextafter(middle, 1.0);
      return;
    }
    (*sign == sign_at_low_ ? above_ : below_) = middle;
  }
}

template <typename P>
int RootOf<P>::sign_of(const P& p) const {
  if (const auto sign = value_at(rounded_coefficients(p), enclosure()).sign()) return *sign;
  if (is_zero(p)) return 0;
  ++exact_sign_count();
  return SignSequence<P>(polynomial_, p).sum_between(low_, high_);
}

template <typename P>
int RootOf<P>::compare(const Time& other) const {
  if (compare_numbers(other, low_) <= 0) return 1;
  if (compare_numbers(other, high_) >= 0) return -1;
  const int sign = detail::sign_at(polynomial_, other);
  if (sign == 0) return 0;
  return sign == sign_at_low_ ? 1 : -1;
}

template <typename P>
int RootOf<P>::compare(const RootOf& other) const {
  if (below_ <= other.above_) return -1;
  if (above_ >= other.below_) return 1;
  if (compare(other.low_) <= 0) return -1;
  if (compare(other.high_) >= 0) return 1;
  const int sign = sign_of(other.polynomial_);
  if (sign == 0) return 0;
  return sign == other.sign_at_low_ ? -1 : 1;
}

template <typename P>
float RootOf<P>::rounded_down() const {
  // The float of `low` is not above the time, the float of `high` is above it.
  std::uint32_t low = bits_below(above_), high = bits_below(below_) + 1;
  while (high - low > 1) {
    const std::uint32_t middle = low + (high - low) / 2;
    (compare(dyadic<P>(double{float_from(middle)})) >= 0 ? low : high) = middle;
  }
  return float_from(low);
}

template <typename P>
void find_critical_times(const P& p, RootsOf<P>& found) {
  found.count = 0;
  if (is_zero(p)) return;
  P inner = p;
  divide_out_ends(inner);
  Isolation<P>(found).search(inner);
}

template bool is_zero(const Cubic& p);
template bool is_zero(const Sextic& p);
template Cubic derivative(const Cubic& p);
template Sextic derivative(const Sextic& p);
template Dyadic dyadic<Cubic>(double time);
template DyadicOf<Sextic> dyadic<Sextic>(double time);
template int sign_at(const Cubic& p, const Dyadic& time);
template int sign_at(const Sextic& p, const DyadicOf<Sextic>& time);
template class RootOf<Cubic>;
template class RootOf<Sextic>;
template void find_critical_times(const Cubic& p, CriticalTimes& found);
template void find_critical_times(const Sextic& p, RootsOf<Sextic>& found);

}  // namespace pelt::detail

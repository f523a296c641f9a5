#pragma once

/// Signs at a root are computed by the theorem of Sturm and Tarski. For polynomials f and g, let
/// S_0 = f, S_1 = f' g mod f, S_{i+1} = -(S_{i-1} mod S_i), and let V(x) be the number of sign
/// changes in the sequence of the values S_i(x), without zeros. If neither f(l) nor f(r) is zero,
/// V(l) - V(r) is the sum of the signs of g at the distinct roots of f in (l, r). With g = 1, this
/// is the number of roots. With one root in (l, r), it is the sign of g at this root. Roots of f
/// may be multiple. A positive multiple of a remainder serves as well as the remainder, so no
/// fractions occur: before each step of a division, the dividend is multiplied by the absolute
/// value of the divisor's leading coefficient.
///
/// The remainders are divided by what they are known to contain, which keeps them short: with the
/// leading coefficient g of the last dividend and the factor h, both positive, a remainder after
/// d + 1 steps is a multiple of g h^d. Then h becomes (next g)^d / h^(d - 1) (Brown, "The
/// subresultant PRS algorithm", 1978). The sequence starts with f' g and f, or with f and f' g if
/// the degree of f' g is lower.
///
/// Bits. Let n be the degree of f and g, and L the number of bits of their coefficients. f' g has
/// degree 2 n - 1 and coefficients of at most 2 L + 6 bits, for n up to 6. An element whose
/// predecessor has degree j + 1 is a determinant of n - j rows of coefficients of f' g and of 2 n -
/// 1 - j rows of coefficients of f. With the sums of 12 terms in one kind of row and of 7 in the
/// other, it has less than (4 n - 1 - 3 j) (L + 16) bits. Before it is divided, a remainder is a
/// sum of products of a coefficient of a dividend of degree a, and of a - b + 1 of its divisor,
/// which has degree b: with b = 1, at most (4 n - 1 - 3 a) (L + 16) + a (4 n + 2 - 3 a) (L + 16)
/// bits.

#include "exact/critical_time.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace pelt::detail {

/// Bits of an element of a sequence (the head of this file).
template <typename P>
inline constexpr unsigned kElementBits = (4 * P::kDegree - 1) * (P::kBits + 16);

/// Bits of a remainder before it is divided.
template <typename P>
constexpr unsigned remainder_bits() {
  unsigned most = 0;
  for (unsigned a = 2; a <= P::kDegree; ++a) {
    const unsigned element = 4 * P::kDegree - 1 - 3 * a;
    most = std::max(most, element + a * (element + 3));
  }
  return most * (P::kBits + 16);
}

/// Room for all that the head of this file counts.
template <typename P>
using WideInteger = BigInteger<remainder_bits<P>()>;

/// Returns -1 for the zero polynomial.
template <typename Integers>
int degree_of(const Integers& coefficients) {
  int result = static_cast<int>(coefficients.size()) - 1;
  while (result >= 0 && coefficients[static_cast<std::size_t>(result)].sign() == 0) --result;
  return result;
}

/// The sign of a polynomial by Horner's rule: of the sum of coefficients[i] m^i 2^(k (n - i)) for
/// the time m / 2^k.
template <typename P, typename Integers>
int horner_sign(const Integers& coefficients, const DyadicOf<P>& time) {
  int i = degree_of(coefficients);
  if (i < 0) return 0;
  WideInteger<P> sum(coefficients[static_cast<std::size_t>(i)]), product;
  for (unsigned shift = time.exponent; i-- > 0; shift += time.exponent) {
    product.assign_product(sum, time.numerator);
    sum = WideInteger<P>(coefficients[static_cast<std::size_t>(i)]);
    sum <<= shift;
    sum += product;
  }
  return sum.sign();
}

/// Replaces `dividend` by its remainder, multiplied once per step by the absolute value of the
/// divisor's leading coefficient.
template <typename Integer, typename Divisor>
void take_remainder(std::span<Integer> dividend, const Divisor& divisor) {
  const auto n = static_cast<std::size_t>(degree_of(divisor));
  Integer positive(divisor[n]), factor, product;
  if (positive.sign() < 0) positive.negate();
  for (std::size_t lead = dividend.size(); lead-- > n;) {
    factor = dividend[lead];
    if (divisor[n].sign() > 0) factor.negate();
    for (std::size_t i = 0; i < lead; ++i) {
      product.assign_product(dividend[i], positive);
      dividend[i] = product;
      if (i < lead - n) continue;
      product.assign_product(divisor[i - (lead - n)], factor);
      dividend[i] += product;
    }
    dividend[lead] = Integer();
  }
}

/// Counts the changes in a list of signs, without zeros.
class SignChanges {
 public:
  void add(int sign) {
    if (sign == 0) return;
    count_ += previous_ == -sign;
    previous_ = sign;
  }

  int count() const { return count_; }

 private:
  int count_ = 0, previous_ = 0;
};

/// The sequence of Sturm and Tarski of two polynomials.
template <typename P>
class SignSequence {
 public:
  SignSequence(const P& f, const P& g) {
    set(0, f.coefficients, 1);
    Dividend dividend = derivative_times(f, g);
    const int degree_of_product = degree_of(dividend);
    if (degree_of_product < 0) return;
    if (degree_of_product < degree_of(f.coefficients)) {
      set(1, dividend, 1);
    } else {
      append_remainder(dividend, 1);
    }
    for (std::size_t k = 1; last_ == k && degree_of(element(k)) > 0; ++k) {
      for (std::size_t i = 0; i < dividend.size(); ++i)
        dividend[i] =
            i < element(k - 1).size() ? WideInteger<P>(element(k - 1)[i]) : WideInteger<P>();
      append_remainder(dividend, -1);
    }
  }

  /// Returns the sum of the signs of g at the roots of f in the open interval. Precondition: f is
  /// not zero at its ends.
  int sum_between(const DyadicOf<P>& low, const DyadicOf<P>& high) const {
    return changes_at(low) - changes_at(high);
  }

 private:
  static constexpr std::size_t kDegree = P::kDegree;
  using Element = BigInteger<kElementBits<P>>;
  using Dividend = std::array<WideInteger<P>, 2 * kDegree>;

  static Dividend derivative_times(const P& f, const P& g) {
    Dividend product;
    WideInteger<P> slope, term;
    for (std::size_t i = 1; i <= kDegree; ++i) {
      slope.assign_product(f.coefficients[i], WideInteger<P>(static_cast<std::int64_t>(i)));
      for (std::size_t k = 0; k <= kDegree; ++k) {
        term.assign_product(slope, g.coefficients[k]);
        product[i - 1 + k] += term;
      }
    }
    return product;
  }

  /// Element k has at most the degree n - k.
  static constexpr std::size_t begin_of(std::size_t k) {
    return k * (kDegree + 1) - k * (k - 1) / 2;
  }
  std::span<const Element> element(std::size_t k) const {
    return {&coefficients_[begin_of(k)], kDegree + 1 - k};
  }

  /// Sets element k to a polynomial, or to its negative.
  template <typename Integers>
  void set(std::size_t k, const Integers& values, int sign) {
    for (std::size_t i = 0; i < kDegree + 1 - k; ++i) {
      Element& coefficient = coefficients_[begin_of(k) + i];
      coefficient = Element(values[i]);
      if (sign < 0) coefficient.negate();
    }
    last_ = k;
  }

  /// Appends the remainder of a division by the last element, or its negative, unless it is zero.
  void append_remainder(Dividend& dividend, int sign) {
    const std::span<const Element> divisor = element(last_);
    const int n = degree_of(divisor), degree_of_dividend = degree_of(dividend);
    const int steps = degree_of_dividend - n;
    take_remainder(std::span(dividend).first(static_cast<std::size_t>(degree_of_dividend) + 1),
                   divisor);
    for (std::size_t i = 0; i < static_cast<std::size_t>(n); ++i) {
      dividend[i].divide_exactly(lead_);
      for (int step = 0; step < steps; ++step) dividend[i].divide_exactly(factor_);
    }
    lead_ = divisor[static_cast<std::size_t>(n)];
    if (lead_.sign() < 0) lead_.negate();
    raise_factor(steps);
    if (degree_of(dividend) >= 0) set(last_ + 1, dividend, sign);
  }

  /// factor = lead^steps / factor^(steps - 1). All intermediate quotients are integers.
  void raise_factor(int steps) {
    if (steps == 0) return;
    WideInteger<P> power(lead_), product;
    for (int step = 1; step < steps; ++step) {
      product.assign_product(power, lead_);
      power = product;
      power.divide_exactly(factor_);
    }
    factor_ = Element(power);
  }

  int changes_at(const DyadicOf<P>& time) const {
    SignChanges changes;
    for (std::size_t k = 0; k <= last_; ++k) changes.add(horner_sign<P>(element(k), time));
    return changes.count();
  }

  std::array<Element, (kDegree + 1) * (kDegree + 2) / 2> coefficients_;  // of all elements
  std::size_t last_ = 0;                                                 // number of an element
  Element lead_ = Element(1), factor_ = Element(1);
};

}  // namespace pelt::detail

#pragma once

/// Exact times at which a polynomial vanishes, and exact signs of other polynomials at these times.

#include "exact/big_integer.hpp"
#include "exact/exact_number.hpp"

#include <array>
#include <cstddef>

namespace pelt::detail {

/// The polynomial sum of coefficients[i] t^i. Precondition of each operation: the result has at
/// most the degree `kDegree`, and coefficients of at most `kBits` bits.
template <std::size_t kDegree_, unsigned kBits_>
struct Polynomial {
  static constexpr std::size_t kDegree = kDegree_;
  static constexpr unsigned kBits = kBits_;
  using Coefficient = BigInteger<kBits>;

  std::array<Coefficient, kDegree + 1> coefficients;

  friend Polynomial operator+(Polynomial p, const Polynomial& q) {
    for (std::size_t i = 0; i <= kDegree; ++i) p.coefficients[i] += q.coefficients[i];
    return p;
  }
  friend Polynomial operator-(Polynomial p, const Polynomial& q) {
    for (std::size_t i = 0; i <= kDegree; ++i) p.coefficients[i] -= q.coefficients[i];
    return p;
  }
  friend Polynomial operator*(const Polynomial& p, const Polynomial& q) {
    Polynomial result;
    Coefficient product;
    for (std::size_t i = 0; i <= kDegree; ++i) {
      if (p.coefficients[i].sign() == 0) continue;
      for (std::size_t k = 0; k <= kDegree; ++k) {
        if (q.coefficients[k].sign() == 0) continue;
        PELT_ASSERT(i + k <= kDegree);
        product.assign_product(p.coefficients[i], q.coefficients[k]);
        result.coefficients[i + k] += product;
      }
    }
    return result;
  }
};

/// Bits of a coordinate. Float32 coordinates below 2^61 are multiples of 2^-149 and need 210 bits.
inline constexpr unsigned kCoordinateBits = 212;

/// Bits of a coefficient of two moving triangles (`moving_polynomials.hpp` derives them).
inline constexpr unsigned kCoefficientBits = 3 * kCoordinateBits + 10;

/// The bits of polynomials include room for the sums of coefficients that derivatives and quotients
/// contain (critical_time.cpp).
using Cubic = Polynomial<3, kCoefficientBits + 4>;
using Coefficient = Cubic::Coefficient;

/// For a moving triangle and a region (moving_faces.cpp, moving_capsule.cpp).
using Sextic = Polynomial<6, 1'720>;

/// The functions below exist for Cubic and Sextic.
template <typename P>
bool is_zero(const P& p);

/// Precondition: p is a polynomial of moving triangles, or a derivative of one.
template <typename P>
P derivative(const P& p);

/// The time numerator / 2^exponent, from 0 to 1.
template <typename P>
struct DyadicOf {
  static constexpr unsigned kBits = (P::kDegree - 1) * (P::kBits + 2) + 36 * P::kDegree;

  BigInteger<kBits> numerator;
  unsigned exponent = 0;
};

using Dyadic = DyadicOf<Cubic>;

/// Precondition: `time` is from 0 to 1 and a float, or a multiple of 2^-1000.
template <typename P = Cubic>
DyadicOf<P> dyadic(double time);

/// Returns the sign of p(time).
template <typename P>
int sign_at(const P& p, const DyadicOf<P>& time);

/// Returns the sign of p just after a time: that of its first derivative that is not zero then.
/// `sign_of(p)` returns the sign of a polynomial at the time.
template <typename P, typename SignOf>
int sign_just_after(const P& p, const SignOf& sign_of) {
  for (P slope = p; !is_zero(slope); slope = derivative(slope))
    if (const int sign = sign_of(slope)) return sign;
  return 0;
}

/// A number whose error covers all times from `low` to `high`. Precondition: 0 <= low <= high <= 1.
inline Rounded enclosure_of(double low, double high) {
  const double radius = (high - low) / 2;
  return Rounded::within(low + radius, radius * (1 + 0x1p-50) + 0x1p-53 * high);
}

/// The only root of a polynomial in an open interval, at which the polynomial changes its sign.
template <typename P>
class RootOf {
 public:
  using Time = DyadicOf<P>;

  /// An object to assign to.
  RootOf() = default;

  /// Precondition: `polynomial` has exactly one root in the open interval from `low` to `high`, and
  /// its signs at `low` and `high` are 1 and -1 or -1 and 1.
  RootOf(const P& polynomial, const Time& low, const Time& high);

  /// Returns the sign of p at this time.
  int sign_of(const P& p) const;

  /// Returns -1 if this time is before the other one, 0 if they are equal, 1 if it is after it.
  int compare(const Time& other) const;
  int compare(const RootOf& other) const;

  /// Returns the largest float32 that is not above this time.
  float rounded_down() const;

  /// Bounds of this time: it is greater than `above` and less than `below`.
  double above() const { return above_; }
  double below() const { return below_; }

  /// A number whose error covers these bounds.
  Rounded enclosure() const { return enclosure_of(above_, below_); }

 private:
  void refine();

  P polynomial_;
  Time low_, high_;
  int sign_at_low_ = 0;
  double above_ = 0, below_ = 1;
};

using CriticalTime = RootOf<Cubic>;

/// Critical times of one polynomial.
template <typename P>
struct RootsOf {
  struct Entry {
    RootOf<P> time;
    bool is_root = false;  ///< it is certainly a root
  };
  /// Let E(n) be the greatest number of entries for degree n. If e roots have even multiplicity,
  /// there are at most n - 2 e others, and those of the derivative: n or n - 2 + E(n - 1).
  std::array<Entry, 2 + (P::kDegree - 1) * (P::kDegree - 2) / 2> entries;
  std::size_t count = 0;
};

using CriticalTimes = RootsOf<Cubic>;

/// Finds all roots of p in the open interval from 0 to 1. A multiple root is described as a root of
/// a derivative. `found` may then contain other roots of derivatives. The zero polynomial has no
/// critical times.
template <typename P>
void find_critical_times(const P& p, RootsOf<P>& found);

}  // namespace pelt::detail

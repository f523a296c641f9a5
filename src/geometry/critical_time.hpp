#pragma once

/// Exact times at which a polynomial vanishes, and exact signs of other polynomials at these times.

#include "geometry/big_integer.hpp"

#include <array>
#include <cstddef>

namespace pelt::detail {

/// Bits of a coordinate. Float32 coordinates below 2^61 are multiples of 2^-149 and need 210 bits.
inline constexpr unsigned kCoordinateBits = 212;

/// Bits of a coefficient (`moving_polynomials.hpp` derives them), and room for the sums of
/// coefficients that derivatives and quotients of a polynomial contain.
inline constexpr unsigned kCoefficientBits = 3 * kCoordinateBits + 10;
using Coefficient = BigInteger<kCoefficientBits + 4>;

/// The polynomial sum of coefficients[i] t^i.
struct Cubic {
  std::array<Coefficient, 4> coefficients;
};

bool is_zero(const Cubic& p);

/// Precondition: p is a polynomial of two moving triangles, or a derivative of one.
Cubic derivative(const Cubic& p);

/// The time numerator / 2^exponent, from 0 to 1.
struct Dyadic {
  BigInteger<2 * kCoefficientBits + 64> numerator;
  unsigned exponent = 0;
};

/// Precondition: `time` is from 0 to 1 and a float, or a multiple of 2^-1000.
Dyadic dyadic(double time);

/// Returns the sign of p(time).
int sign_at(const Cubic& p, const Dyadic& time);

/// The only root of a polynomial in an open interval, at which the polynomial changes its sign.
class CriticalTime {
 public:
  /// An object to assign to.
  CriticalTime() = default;

  /// Precondition: `polynomial` has exactly one root in the open interval from `low` to `high`, and
  /// its signs at `low` and `high` are 1 and -1 or -1 and 1.
  CriticalTime(const Cubic& polynomial, const Dyadic& low, const Dyadic& high);

  /// Returns the sign of p at this time.
  int sign_of(const Cubic& p) const;

  /// Returns -1 if this time is before the other one, 0 if they are equal, 1 if it is after it.
  int compare(const Dyadic& other) const;
  int compare(const CriticalTime& other) const;

  /// Returns the largest float32 that is not above this time.
  float rounded_down() const;

  /// Bounds of this time: it is greater than `above` and less than `below`.
  double above() const { return above_; }
  double below() const { return below_; }

 private:
  void refine();

  Cubic polynomial_;
  Dyadic low_, high_;
  int sign_at_low_ = 0;
  double above_ = 0, below_ = 1;
};

/// Critical times of one polynomial.
struct CriticalTimes {
  struct Entry {
    CriticalTime time;
    bool is_root = false;  ///< it is certainly a root
  };
  std::array<Entry, 3> entries;
  std::size_t count = 0;
};

/// Finds all roots of p in the open interval from 0 to 1. A multiple root is described as a root of
/// the derivative. `found` may then contain one other root of the derivative. The zero polynomial
/// has no critical times.
void find_critical_times(const Cubic& p, CriticalTimes& found);

}  // namespace pelt::detail

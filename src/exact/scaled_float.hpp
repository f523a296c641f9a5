#pragma once

/// Floats as integers in a common unit, a power of two.

#include "exact/big_integer.hpp"

#include <bit>
#include <cmath>
#include <cstdint>

namespace pelt::detail {

/// A float as an odd number times a power of two; both are 0 for 0.
struct OddTimesPower {
  std::int64_t odd = 0;
  int exponent = 0;

  explicit OddTimesPower(float value) {
    if (value == 0) return;
    const float fraction = std::frexp(value, &exponent);
    odd = static_cast<std::int64_t>(std::ldexp(fraction, 24));
    const int zeros = std::countr_zero(static_cast<std::uint64_t>(odd));
    odd >>= zeros;
    exponent += zeros - 24;
  }
};

/// Returns value / 2^exponent. Precondition: it is an integer of at most `kBits` bits.
template <unsigned kBits>
BigInteger<kBits> scaled(float value, int exponent) {
  const OddTimesPower parts(value);
  BigInteger<kBits> result(parts.odd);
  if (parts.odd != 0) result <<= static_cast<unsigned>(parts.exponent - exponent);
  return result;
}

}  // namespace pelt::detail

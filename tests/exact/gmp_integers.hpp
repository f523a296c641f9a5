#pragma once

/// The library's integers as numbers of GMP, and back.

#include "exact/big_integer.hpp"

#include <gmpxx.h>

#include <cstddef>
#include <cstdint>

namespace pelt::test {

template <unsigned kBits>
mpz_class to_gmp(const detail::BigInteger<kBits>& number) {
  mpz_class result;
  for (unsigned i = number.size(); i-- > 0;) result = (result << 32) + number.limb(i);
  return number.sign() * result;
}

inline std::size_t bits_of(const mpz_class& number) {
  return number == 0 ? 0 : mpz_sizeinbase(number.get_mpz_t(), 2);
}

/// Precondition: the library's integer has as many bits.
template <typename Integer>
Integer from_gmp(const mpz_class& number) {
  Integer result;
  const mpz_class magnitude = abs(number);
  for (std::size_t i = (bits_of(number) + 31) / 32; i-- > 0;) {
    const mpz_class limb = (magnitude >> 32 * i) & 0xFFFFFFFFu;
    result <<= 32;
    result += Integer(static_cast<std::int64_t>(limb.get_ui()));
  }
  if (number < 0) result.negate();
  return result;
}

}  // namespace pelt::test

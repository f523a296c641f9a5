#pragma once

#include "base/assert.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace pelt::detail {

/// An exact integer with room for `kBits` bits: a sign, and a magnitude in limbs of 32 bits. Never
/// allocates, and an operation costs only the limbs that are in use. Precondition of each
/// operation: the result has at most `kBits` bits.
template <unsigned kBits>
class BigInteger {
 public:
  BigInteger() = default;
  explicit BigInteger(std::int64_t value) : sign_((value > 0) - (value < 0)) {
    auto magnitude = static_cast<std::uint64_t>(value);
    if (value < 0) magnitude = 0 - magnitude;
    for (; magnitude != 0; magnitude >>= 32) append(static_cast<std::uint32_t>(magnitude));
  }
  BigInteger(const BigInteger& other) { assign(other); }
  template <unsigned kOther>
  explicit BigInteger(const BigInteger<kOther>& other) {
    assign(other);
  }
  BigInteger& operator=(const BigInteger& other) {
    if (this != &other) assign(other);
    return *this;
  }
  ~BigInteger() = default;

  int sign() const { return sign_; }

  /// Number of bits of the magnitude; 0 for zero.
  unsigned bits() const {
    return size_ == 0 ? 0 : 32 * size_ - static_cast<unsigned>(std::countl_zero(limbs_[size_ - 1]));
  }

  /// Largest power of two that divides the number. Precondition: the number is not zero.
  unsigned trailing_zeros() const {
    PELT_ASSERT(sign_ != 0);
    unsigned i = 0;
    while (limbs_[i] == 0) ++i;
    return 32 * i + static_cast<unsigned>(std::countr_zero(limbs_[i]));
  }

  /// Number of limbs in use, the lowest first.
  unsigned size() const { return size_; }
  std::uint32_t limb(unsigned i) const { return limbs_[i]; }

  void negate() { sign_ = -sign_; }

  BigInteger& operator+=(const BigInteger& other) {
    add(other, other.sign_);
    return *this;
  }
  BigInteger& operator-=(const BigInteger& other) {
    add(other, -other.sign_);
    return *this;
  }
  BigInteger& operator<<=(unsigned count);
  /// Drops the lowest `count` bits of the magnitude.
  BigInteger& operator>>=(unsigned count);

  /// *this = a * b. Precondition: neither factor is *this.
  template <unsigned kA, unsigned kB>
  void assign_product(const BigInteger<kA>& a, const BigInteger<kB>& b);

  /// Divides by a number that is a divisor: of the quotient and the remainder, only the first.
  template <unsigned kOther>
  void divide_exactly(BigInteger<kOther> divisor);

  friend BigInteger operator+(BigInteger a, const BigInteger& b) { return a += b; }
  friend BigInteger operator-(BigInteger a, const BigInteger& b) { return a -= b; }
  friend BigInteger operator-(BigInteger a) {
    a.negate();
    return a;
  }
  friend BigInteger operator*(const BigInteger& a, const BigInteger& b) {
    BigInteger product;
    product.assign_product(a, b);
    return product;
  }
  friend BigInteger operator<<(BigInteger a, unsigned count) { return a <<= count; }

 private:
  /// One limb more than the bits need, because a product or a shift writes it before it turns out
  /// to be zero.
  static constexpr unsigned kLimbs = (kBits + 31) / 32 + 1;

  template <unsigned kOther>
  void assign(const BigInteger<kOther>& other) {
    sign_ = other.sign();
    size_ = other.size();
    PELT_ASSERT(size_ <= kLimbs);
    for (unsigned i = 0; i < size_; ++i) limbs_[i] = other.limb(i);
  }

  void append(std::uint32_t limb) {
    PELT_ASSERT(size_ < kLimbs);
    limbs_[size_++] = limb;
  }

  void trim() {
    while (size_ > 0 && limbs_[size_ - 1] == 0) --size_;
    if (size_ == 0) sign_ = 0;
    PELT_ASSERT(bits() <= kBits);
  }

  /// -1, 0 or 1 if the magnitude is less than, equal to or greater than that of `other`.
  int compare_magnitude(const BigInteger& other) const {
    if (size_ != other.size_) return size_ < other.size_ ? -1 : 1;
    for (unsigned i = size_; i-- > 0;)
      if (limbs_[i] != other.limbs_[i]) return limbs_[i] < other.limbs_[i] ? -1 : 1;
    return 0;
  }

  void add(const BigInteger& other, int sign_of_other);
  void add_magnitude(const BigInteger& other);
  void subtract_magnitude(const BigInteger& less);
  void subtract_from_magnitude(const BigInteger& greater);

  std::array<std::uint32_t, kLimbs>
      limbs_;  // the first size_ are set, the last of them is not zero
  unsigned size_ = 0;
  int sign_ = 0;
};

template <unsigned kBits>
void BigInteger<kBits>::add(const BigInteger& other, int sign_of_other) {
  if (sign_of_other == 0) return;
  if (sign_ == 0) {
    assign(other);
    sign_ = sign_of_other;
  } else if (sign_ == sign_of_other) {
    add_magnitude(other);
  } else if (compare_magnitude(other) >= 0) {
    subtract_magnitude(other);
  } else {
    subtract_from_magnitude(other);
    sign_ = sign_of_other;
  }
}

template <unsigned kBits>
void BigInteger<kBits>::add_magnitude(const BigInteger& other) {
  while (size_ < other.size_) append(0);
  std::uint64_t carry = 0;
  for (unsigned i = 0; i < size_ && (carry != 0 || i < other.size_); ++i) {
    carry += limbs_[i];
    if (i < other.size_) carry += other.limbs_[i];
    limbs_[i] = static_cast<std::uint32_t>(carry);
    carry >>= 32;
  }
  if (carry != 0) append(static_cast<std::uint32_t>(carry));
  PELT_ASSERT(bits() <= kBits);
}

template <unsigned kBits>
void BigInteger<kBits>::subtract_magnitude(const BigInteger& less) {
  std::int64_t borrow = 0;
  for (unsigned i = 0; i < size_ && (borrow != 0 || i < less.size_); ++i) {
    borrow += limbs_[i];
    if (i < less.size_) borrow -= less.limbs_[i];
    limbs_[i] = static_cast<std::uint32_t>(borrow);
    borrow >>= 32;
  }
  trim();
}

template <unsigned kBits>
void BigInteger<kBits>::subtract_from_magnitude(const BigInteger& greater) {
  while (size_ < greater.size_) append(0);
  std::int64_t borrow = 0;
  for (unsigned i = 0; i < size_; ++i) {
    borrow += static_cast<std::int64_t>(greater.limbs_[i]) - limbs_[i];
    limbs_[i] = static_cast<std::uint32_t>(borrow);
    borrow >>= 32;
  }
  trim();
}

template <unsigned kBits>
BigInteger<kBits>& BigInteger<kBits>::operator<<=(unsigned count) {
  if (sign_ == 0) return *this;
  const unsigned limbs = count / 32, bits = count % 32;
  PELT_ASSERT(size_ + limbs + 1 <= kLimbs + (bits == 0));
  std::uint32_t above = 0;
  if (bits == 0) {
    std::copy_backward(limbs_.begin(), limbs_.begin() + size_, limbs_.begin() + size_ + limbs);
    size_ += limbs;
  } else {
    for (unsigned i = size_; i-- > 0;) {
      limbs_[i + limbs + 1] = above | limbs_[i] >> (32 - bits);
      above = limbs_[i] << bits;
    }
    limbs_[limbs] = above;
    size_ += limbs + 1;
  }
  std::fill_n(limbs_.begin(), limbs, 0u);
  trim();
  return *this;
}

template <unsigned kBits>
BigInteger<kBits>& BigInteger<kBits>::operator>>=(unsigned count) {
  const unsigned limbs = std::min(count / 32, size_), bits = count % 32;
  size_ -= limbs;
  for (unsigned i = 0; i < size_; ++i) {
    limbs_[i] = limbs_[i + limbs] >> bits;
    if (bits != 0 && i + 1 < size_) limbs_[i] |= limbs_[i + limbs + 1] << (32 - bits);
  }
  trim();
  return *this;
}

template <unsigned kBits>
template <unsigned kA, unsigned kB>
void BigInteger<kBits>::assign_product(const BigInteger<kA>& a, const BigInteger<kB>& b) {
  sign_ = a.sign() * b.sign();
  size_ = 0;
  if (sign_ == 0) return;
  size_ = a.size() + b.size();
  PELT_ASSERT(size_ <= kLimbs);
  std::fill_n(limbs_.begin(), size_, 0u);
  for (unsigned i = 0; i < a.size(); ++i) {
    const std::uint64_t factor = a.limb(i);
    std::uint64_t carry = 0;
    for (unsigned k = 0; k < b.size(); ++k) {
      carry += factor * b.limb(k) + limbs_[i + k];
      limbs_[i + k] = static_cast<std::uint32_t>(carry);
      carry >>= 32;
    }
    limbs_[i + b.size()] = static_cast<std::uint32_t>(carry);
  }
  trim();
}

/// The inverse of an odd number modulo 2^32, by Newton's method. Each step doubles the number of
/// correct bits, of which the first value has three.
inline std::uint32_t inverse_of_odd(std::uint32_t odd) {
  std::uint32_t inverse = odd;
  for (int step = 0; step < 4; ++step) inverse *= 2 - odd * inverse;
  return inverse;
}

/// From the lowest limb: each limb of the quotient makes one limb of the dividend zero (Jebelean,
/// "An algorithm for exact division", 1993).
template <unsigned kBits>
template <unsigned kOther>
void BigInteger<kBits>::divide_exactly(BigInteger<kOther> divisor) {
  if (sign_ == 0) return;
  const unsigned zeros = divisor.trailing_zeros();
  divisor >>= zeros;
  *this >>= zeros;
  PELT_ASSERT(size_ >= divisor.size());
  const unsigned size = size_ - divisor.size() + 1;
  const std::uint32_t inverse = inverse_of_odd(divisor.limb(0));
  for (unsigned i = 0; i < size; ++i) {
    const std::uint64_t quotient = limbs_[i] * inverse;
    std::uint64_t borrow = 0;
    for (unsigned k = 0; i + k < size && (k < divisor.size() || borrow != 0); ++k) {
      if (k < divisor.size()) borrow += quotient * divisor.limb(k);
      const auto low = static_cast<std::uint32_t>(borrow);
      borrow = (borrow >> 32) + (limbs_[i + k] < low ? 1 : 0);
      limbs_[i + k] -= low;
    }
    limbs_[i] = static_cast<std::uint32_t>(quotient);
  }
  size_ = size;
  sign_ *= divisor.sign();
  trim();
}

/// Returns number / 2^halvings rounded to a double, with a relative error below 2^-52 or, if the
/// result is below 2^-1022, an error below 2^-1074. Precondition: the result is below 2^1023.
template <unsigned kBits>
double rounded(BigInteger<kBits> number, unsigned halvings = 0) {
  const unsigned bits = number.bits(), dropped = bits > 64 ? bits - 64 : 0;
  number >>= dropped;
  std::uint64_t magnitude = 0;
  for (unsigned i = number.size(); i-- > 0;) magnitude = magnitude << 32 | number.limb(i);
  return number.sign() * std::ldexp(static_cast<double>(magnitude),
                                    static_cast<int>(dropped) - static_cast<int>(halvings));
}

}  // namespace pelt::detail

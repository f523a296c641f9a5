#pragma once

#include "exact/big_integer.hpp"

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

}  // namespace pelt::detail

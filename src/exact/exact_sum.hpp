#pragma once

#include "base/assert.hpp"

#include <array>
#include <cfloat>
#include <cstddef>
#include <limits>
#include <span>

namespace pelt::detail {

static_assert(std::numeric_limits<double>::is_iec559 && FLT_EVAL_METHOD == 0,
              "the proofs below need every operation rounded to double once");

/// Two-Sum (theorem 7 of the paper below): a + b == sum + result, exactly.
inline double rounding_error(double a, double b, double sum) {
  const double b_part = sum - a, a_part = sum - b_part;
  return (a - a_part) + (b - b_part);
}

/// An exact sum of at most `kCapacity` doubles that are not zero: a nonoverlapping expansion, terms
/// of increasing magnitude of which the last has the sign of the whole (Shewchuk, "Adaptive
/// precision floating-point arithmetic and fast robust geometric predicates", 1997, section 2).
template <std::size_t kCapacity>
class ExactSum {
 public:
  /// Grow-Expansion (theorem 10) without zero terms: adds at most one term.
  void add(double value) {
    if (value == 0) return;
    PELT_ASSERT(size_ < kCapacity);
    std::size_t kept = 0;
    for (std::size_t i = 0; i < size_; ++i) {
      const double sum = value + terms_[i];
      const double rest = rounding_error(value, terms_[i], sum);
      if (rest != 0) terms_[kept++] = rest;
      value = sum;
    }
    if (value != 0) terms_[kept++] = value;
    size_ = kept;
  }

  /// Terms whose sum is the exact sum of all values.
  std::span<const double> terms() const { return {terms_.data(), size_}; }

  /// Returns the sum with an error below one unit in the last place, like Shewchuk's ESTIMATE.
  double rounded() const {
    double sum = 0;
    for (std::size_t i = 0; i < size_; ++i) sum += terms_[i];
    return sum;
  }

  int sign() const {
    if (size_ == 0) return 0;
    return terms_[size_ - 1] > 0 ? 1 : -1;
  }

 private:
  std::array<double, kCapacity> terms_;  // the first size_ are set
  std::size_t size_ = 0;
};

}  // namespace pelt::detail

#pragma once

/// Products and determinants of three dimensions, added to an exact sum. Factors are floats or
/// differences of floats, so that nothing overflows or underflows.

#include "base/assert.hpp"
#include "base/vec3.hpp"

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

/// Dekker's product (Shewchuk 1997, theorem 18): value + error == a * b, exactly.
struct ExactProduct {
  ExactProduct(double a, double b) : value(a * b) {
    const double a_high = high_half(a), a_low = a - a_high;
    const double b_high = high_half(b), b_low = b - b_high;
    error = a_low * b_low - (((value - a_high * b_high) - a_low * b_high) - a_high * b_low);
  }

  static double high_half(double a) {
    const double shifted = 0x8000001p0 * a;
    return shifted - (shifted - a);
  }

  double value, error;
};

/// Adds four terms, or two if the factors are floats, because the product of two floats has 48
/// bits.
template <std::size_t kCapacity>
void add_product(ExactSum<kCapacity>& sum, double x, double y, double z) {
  const ExactProduct xy(x, y), high(xy.value, z), low(xy.error, z);
  for (const double term : {low.error, low.value, high.error, high.value}) sum.add(term);
}

/// det(p, q, r): six products.
template <std::size_t kCapacity>
void add_determinant(ExactSum<kCapacity>& sum, const Vec3d& p, const Vec3d& q, const Vec3d& r) {
  add_product(sum, p.x, q.y, r.z);
  add_product(sum, q.x, r.y, p.z);
  add_product(sum, r.x, p.y, q.z);
  add_product(sum, -q.x, p.y, r.z);
  add_product(sum, -r.x, q.y, p.z);
  add_product(sum, -p.x, r.y, q.z);
}

/// Returns det(b - a, c - a, d - a) = det(b, c, d) - det(a, c, d) + det(a, b, d) - det(a, b, c),
/// with an error below one unit in the last place.
inline double exact_orientation(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& d) {
  ExactSum<96> sum;
  add_determinant(sum, b, c, d);
  add_determinant(sum, c, a, d);
  add_determinant(sum, a, b, d);
  add_determinant(sum, b, a, c);
  return sum.rounded();
}

}  // namespace pelt::detail

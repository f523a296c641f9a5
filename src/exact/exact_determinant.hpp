#pragma once

/// Products and determinants of three dimensions, added to an exact sum. Factors are floats or
/// differences of floats, so that nothing overflows or underflows.

#include "base/vec3.hpp"
#include "exact/exact_sum.hpp"

namespace pelt::detail {

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

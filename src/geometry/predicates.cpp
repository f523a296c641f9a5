#include "geometry/predicates.hpp"

#include <array>
#include <cfloat>
#include <cstddef>
#include <limits>

namespace pelt::detail {
namespace {

static_assert(std::numeric_limits<double>::is_iec559 && FLT_EVAL_METHOD == 0,
              "the proofs below need every operation rounded to double once");

int sign(double value) { return (value > 0) - (value < 0); }

/// Two-Sum (Shewchuk, theorem 7): a + b == sum + result, exactly.
double rounding_error(double a, double b, double sum) {
  const double b_part = sum - a, a_part = sum - b_part;
  return (a - a_part) + (b - b_part);
}

/// An exact sum of doubles: a nonoverlapping expansion, terms of increasing magnitude of which the
/// last has the sign of the whole (Shewchuk, "Adaptive precision floating-point arithmetic and fast
/// robust geometric predicates", 1997, section 2).
template <std::size_t kCapacity>
class ExactSum {
 public:
  /// Grow-Expansion (theorem 10) that keeps no zeros.
  void add(double value) {
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

  int sign() const { return size_ == 0 ? 0 : detail::sign(terms_[size_ - 1]); }

 private:
  std::array<double, kCapacity> terms_;  // the first size_ are set
  std::size_t size_ = 0;
};

using Sum3d = ExactSum<48>;

/// Dekker's product (theorem 18): value + error == a * b, exactly.
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

void add_product(Sum3d& sum, double x, double y, double z) {
  const ExactProduct xy(x, y), high(xy.value, z), low(xy.error, z);
  for (const double term : {low.error, low.value, high.error, high.value}) sum.add(term);
}

void add_determinant(Sum3d& sum, const Vec3d& p, const Vec3d& q, const Vec3d& r) {
  add_product(sum, p.x, q.y, r.z);
  add_product(sum, q.x, r.y, p.z);
  add_product(sum, r.x, p.y, q.z);
  add_product(sum, -q.x, p.y, r.z);
  add_product(sum, -r.x, q.y, p.z);
  add_product(sum, -p.x, r.y, q.z);
}

bool is_exact_difference(const Vec3d& difference, const Vec3d& a, const Vec3d& b) {
  return rounding_error(a.x, -b.x, difference.x) == 0 &&
         rounding_error(a.y, -b.y, difference.y) == 0 &&
         rounding_error(a.z, -b.z, difference.z) == 0;
}

}  // namespace

std::uint64_t& exact_sign_count() {
  thread_local std::uint64_t count = 0;
  return count;
}

int OrientedPlane::exact_side(const Vec3& d) const {
  if (d == a_ || d == b_ || d == c_ || a_ == b_ || b_ == c_ || c_ == a_) return 0;
  ++exact_sign_count();
  const Vec3d pb(b_), pc(c_), pd(d);
  const Vec3d u = pb - origin_, v = pc - origin_, w = pd - origin_;
  Sum3d sum;
  if (is_exact_difference(u, pb, origin_) && is_exact_difference(v, pc, origin_) &&
      is_exact_difference(w, pd, origin_)) {
    add_determinant(sum, u, v, w);
  } else {
    add_determinant(sum, pb, pc, pd);
    add_determinant(sum, pc, origin_, pd);
    add_determinant(sum, origin_, pb, pd);
    add_determinant(sum, pc, pb, origin_);
  }
  return sum.sign();
}

int orient2d(const Vec2d& a, const Vec2d& b, const Vec2d& c) {
  const double left = (b.x - a.x) * (c.y - a.y), right = (b.y - a.y) * (c.x - a.x);
  const double determinant = left - right;
  // Each product has three relative errors 2^-53 and their difference one more; 2^-50 is twice
  // that.
  const double error = 0x1p-50 * (std::abs(left) + std::abs(right));
  if (determinant > error) return 1;
  if (determinant < -error) return -1;
  if (error == 0) return 0;

  ++exact_sign_count();
  ExactSum<6> sum;
  for (const double term : {a.x * b.y, b.x * c.y, c.x * a.y}) sum.add(term);
  for (const double term : {b.x * a.y, c.x * b.y, a.x * c.y}) sum.add(-term);
  return sum.sign();
}

}  // namespace pelt::detail

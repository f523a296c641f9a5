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
  /// Two-Sum (theorem 7): a + b == sum + result, exactly.
  static double rounding_error(double a, double b, double sum) {
    const double b_part = sum - a, a_part = sum - b_part;
    return (a - a_part) + (b - b_part);
  }

  std::array<double, kCapacity> terms_;  // the first size_ are set
  std::size_t size_ = 0;
};

using Sum3d = ExactSum<48>;

/// The product of two floats: their 24-bit mantissas make one of at most 48 bits, so it is exact.
double product(float a, float b) { return double{a} * double{b}; }

/// Adds xy * z, where xy has 48 bits: split into halves of at most 26 bits (Veltkamp), each of
/// which times 24 bits is exact.
void add_product(Sum3d& sum, double xy, float z) {
  const double shifted = 0x8000001p0 * xy;
  const double high = shifted - (shifted - xy), low = xy - high;
  sum.add(high * double{z});
  sum.add(low * double{z});
}

/// Adds det(p, q, r).
void add_determinant(Sum3d& sum, const Vec3& p, const Vec3& q, const Vec3& r) {
  add_product(sum, product(p.x, q.y), r.z);
  add_product(sum, product(q.x, r.y), p.z);
  add_product(sum, product(r.x, p.y), q.z);
  add_product(sum, -product(q.x, p.y), r.z);
  add_product(sum, -product(r.x, q.y), p.z);
  add_product(sum, -product(p.x, r.y), q.z);
}

}  // namespace

std::uint64_t& exact_sign_count() {
  thread_local std::uint64_t count = 0;
  return count;
}

int OrientedPlane::exact_side(const Vec3& d) const {
  if (d == a_ || d == b_ || d == c_) return 0;
  ++exact_sign_count();
  Sum3d sum;
  add_determinant(sum, b_, c_, d);
  add_determinant(sum, c_, a_, d);
  add_determinant(sum, a_, b_, d);
  add_determinant(sum, c_, b_, a_);
  return sum.sign();
}

int orient2d(const Vec2& a, const Vec2& b, const Vec2& c) {
  const double ux = double{b.x} - double{a.x}, uy = double{b.y} - double{a.y};
  const double vx = double{c.x} - double{a.x}, vy = double{c.y} - double{a.y};
  const double left = ux * vy, right = uy * vx;
  // Either product has three relative errors 2^-53 and their difference one more; equal signs make
  // |left| + |right| large against the determinant, opposite ones do not.
  const double determinant = left - right;
  const double error = 0x1p-50 * ((left < 0 ? -left : left) + (right < 0 ? -right : right));
  if (determinant > error) return 1;
  if (determinant < -error) return -1;
  if (error == 0) return 0;

  ++exact_sign_count();
  ExactSum<6> sum;
  sum.add(product(a.x, b.y));
  sum.add(-product(a.y, b.x));
  sum.add(product(b.x, c.y));
  sum.add(-product(b.y, c.x));
  sum.add(product(c.x, a.y));
  sum.add(-product(c.y, a.x));
  return sum.sign();
}

}  // namespace pelt::detail

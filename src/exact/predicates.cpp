#include "exact/predicates.hpp"

#include "exact/exact_determinant.hpp"

namespace pelt::detail {
namespace {

/// Room for the determinants of three dimensions. Of four determinants of points, 24 products have
/// three floats for factors: two of these multiply to 48 bits, exactly, so each product is a sum of
/// two doubles. Of one determinant of differences, six products are sums of four doubles.
using Sum3d = ExactSum<48>;

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

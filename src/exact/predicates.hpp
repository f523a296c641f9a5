#pragma once

/// Signs of orientation determinants, exact on float32 coordinates: -1, 0 or 1.
///
/// A filter in double decides all but nearly degenerate cases, which exact arithmetic decides. No
/// operation overflows or underflows in either: differences and products of floats are multiples of
/// 2^-447 below 2^400 up to degree three, both well inside the range of double.

#include <pelt/math.hpp>

#include "base/vec3.hpp"

#include <cstdint>

namespace pelt::detail {

/// The plane through three points, prepared for testing many other points. Stores references to the
/// points.
class OrientedPlane {
 public:
  /// With e = 2^-53, each of the six products of the determinant gathers at most 8 relative errors
  /// e: three differences, two products, three sums; in absolute terms at most 6 * 8 e |u||v||w| =
  /// 48 e |u||v||w| in the largest components, and 56 e covers the terms of second order and the
  /// rounding of the bound itself.
  static constexpr double kRelativeError = 56 * 0x1p-53;

  OrientedPlane(const Vec3& a, const Vec3& b, const Vec3& c) : a_(a), b_(b), c_(c), origin_(a) {
    const Vec3d u = Vec3d(b) - origin_, v = Vec3d(c) - origin_;
    normal_ = cross(u, v);
    error_ = kRelativeError * max_abs(u) * max_abs(v);
  }

  /// Returns the sign of det(b - a, c - a, d - a): 1 if a, b, c appear counter-clockwise from d, -1
  /// behind the plane, 0 on it (always 0 if a, b, c are collinear).
  int side(const Vec3& d) const {
    const Vec3d w = Vec3d(d) - origin_;
    const double determinant = dot(normal_, w), error = error_ * max_abs(w);
    if (determinant > error) return 1;
    if (determinant < -error) return -1;
    return exact_side(d);
  }

 private:
  int exact_side(const Vec3& d) const;

  const Vec3 &a_, &b_, &c_;
  Vec3d origin_, normal_;
  double error_ = 0;
};

/// The sign of det(b - a, c - a, d - a).
inline int orient3d(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  return OrientedPlane(a, b, c).side(d);
}

/// A point of the plane with float32 coordinates, widened so that a product of two is exact.
struct Vec2d {
  double x = 0, y = 0;
};

/// A point seen along an axis.
inline Vec2d without(const Vec3& p, int axis) {
  return axis == 0 ? Vec2d{p.y, p.z} : axis == 1 ? Vec2d{p.z, p.x} : Vec2d{p.x, p.y};
}

/// The sign of det(b - a, c - a): 1 if a, b, c turn counter-clockwise.
int orient2d(const Vec2d& a, const Vec2d& b, const Vec2d& c);

/// Number of signs that needed exact arithmetic on this thread, for tests.
std::uint64_t& exact_sign_count();

}  // namespace pelt::detail

#pragma once

#include "asset/angles.hpp"
#include "base/vec3.hpp"

#include <array>
#include <cmath>

namespace pelt::asset {

/// A quaternion, which is a rotation if its norm is 1; w is the real part.
struct Quaternion {
  double x = 0, y = 0, z = 0, w = 1;
};

inline double dot(const Quaternion& a, const Quaternion& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z + a.w * b.w;
}

/// a * s + b * t
inline Quaternion blend(const Quaternion& a, double s, const Quaternion& b, double t) {
  return {a.x * s + b.x * t, a.y * s + b.y * t, a.z * s + b.z * t, a.w * s + b.w * t};
}

/// Returns the quaternion scaled to norm 1; the identity for zero.
inline Quaternion normalised(const Quaternion& q) {
  const double norm = std::sqrt(dot(q, q));
  if (!(norm > 0)) return {};
  return {q.x / norm, q.y / norm, q.z / norm, q.w / norm};
}

/// The rotation that applies `b` first, then `a`.
inline Quaternion operator*(const Quaternion& a, const Quaternion& b) {
  return {
      a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y, a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x,
      a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w, a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z};
}

/// The inverse of a unit quaternion.
inline Quaternion conjugate(const Quaternion& q) { return {-q.x, -q.y, -q.z, q.w}; }

/// Precondition: `q` is a unit quaternion.
inline detail::Vec3d rotate(const Quaternion& q, const detail::Vec3d& v) {
  const detail::Vec3d axis(q.x, q.y, q.z);
  const detail::Vec3d twice = 2.0 * cross(axis, v);
  return v + q.w * twice + cross(axis, twice);
}

/// Interpolates from `a` (t = 0) to `b` (t = 1) at constant speed along the shorter arc.
/// Preconditions: unit quaternions, 0 <= t <= 1.
inline Quaternion slerp(const Quaternion& a, const Quaternion& b, double t) {
  const double signed_cosine = dot(a, b);
  const double sign = signed_cosine < 0 ? -1 : 1;
  const double cosine = sign * signed_cosine;
  const double squared_sine = 1 - cosine * cosine;
  // Here the quotients of sines are 1 - t and t within 1e-12, and 1 - cosine^2 is mostly rounding.
  if (squared_sine < 1e-12) return normalised(blend(a, 1 - t, b, sign * t));
  const double sine_of_angle = std::sqrt(squared_sine);
  const double angle = angle_of(sine_of_angle, cosine);
  return blend(a, sine((1 - t) * angle) / sine_of_angle, b, sign * sine(t * angle) / sine_of_angle);
}

}  // namespace pelt::asset

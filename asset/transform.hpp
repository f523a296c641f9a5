#pragma once

/// Angles, quaternions and affine maps, in double and without libm, whose last bits differ between
/// platforms; and validation of a file's rotations and matrices.

#include <pelt/math.hpp>

#include "base/vec3.hpp"

#include <array>
#include <cmath>
#include <optional>

namespace pelt::asset {

inline constexpr double kPi = 3.14159265358979323846;

/// sin x within 3e-16. Precondition: |x| <= pi / 2.
double sine(double x);

/// Sine and cosine of an angle in turns (1 turn = 2 pi), within 1e-15 and exactly periodic where
/// `turns + 1` is exact. Precondition: |turns| < 2^30.
double sine_of_turns(double turns);
double cosine_of_turns(double turns);

/// The angle in [0, pi / 2] whose sine and cosine have the ratio of the arguments, within 1e-15.
/// Precondition: both >= 0, not both 0, and their squares neither overflow nor vanish.
double angle_of(double sine, double cosine);

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

/// An affine map in double, the upper three rows of a 4 x 4 matrix by columns: element
/// (row, column) is `[3 * column + row]`.
using Affine = std::array<double, 12>;

inline Affine affine_of(const Matrix4& matrix) {
  Affine result;
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 3; ++row) result[3 * column + row] = matrix.m[4 * column + row];
  }
  return result;
}

/// Rounds to float; the last row is 0 0 0 1.
inline Matrix4 matrix_of(const Affine& affine) {
  Matrix4 result;
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 3; ++row) {
      result.m[4 * column + row] = static_cast<float>(affine[3 * column + row]);
    }
  }
  return result;
}

/// The map that applies `b` first, then `a`.
inline Affine operator*(const Affine& a, const Affine& b) {
  Affine result;
  for (std::size_t column = 0; column < 4; ++column) {
    for (std::size_t row = 0; row < 3; ++row) {
      double sum = a[row] * b[3 * column] + a[3 + row] * b[3 * column + 1];
      sum = sum + a[6 + row] * b[3 * column + 2];
      result[3 * column + row] = column < 3 ? sum : sum + a[9 + row];
    }
  }
  return result;
}

/// Returns the inverse, or nothing if the map is singular up to rounding.
inline std::optional<Affine> inverted(const Affine& m) {
  const auto minor = [&](int a, int b, int c, int d) { return m[a] * m[d] - m[b] * m[c]; };
  const double c0 = minor(4, 5, 7, 8), c1 = minor(7, 8, 1, 2), c2 = minor(1, 2, 4, 5);
  const double determinant = m[0] * c0 + m[3] * c1 + m[6] * c2;
  double size = 1;
  for (std::size_t column = 0; column < 3; ++column) {
    const double* v = m.data() + 3 * column;
    size *= std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
  }
  if (!(std::fabs(determinant) > 1e-9 * size)) return std::nullopt;
  Affine inverse = {c0,
                    c1,
                    c2,
                    minor(6, 8, 3, 5),
                    minor(0, 2, 6, 8),
                    minor(3, 5, 0, 2),
                    minor(3, 4, 6, 7),
                    minor(6, 7, 0, 1),
                    minor(0, 1, 3, 4),
                    0,
                    0,
                    0};
  for (double& entry : inverse) entry /= determinant;
  for (int row = 0; row < 3; ++row) {
    inverse[9 + row] = -(inverse[row] * m[9] + inverse[3 + row] * m[10] + inverse[6 + row] * m[11]);
  }
  return inverse;
}

/// Returns T * R * S. The rotation is not normalised, as in renderers.
inline Affine compose(const std::array<double, 3>& translation, const Quaternion& q,
                      const std::array<double, 3>& scale) {
  const double xx = q.x * q.x, yy = q.y * q.y, zz = q.z * q.z;
  const double xy = q.x * q.y, xz = q.x * q.z, yz = q.y * q.z;
  const double wx = q.w * q.x, wy = q.w * q.y, wz = q.w * q.z;
  return {scale[0] * (1 - 2 * (yy + zz)),
          scale[0] * (2 * (xy + wz)),
          scale[0] * (2 * (xz - wy)),
          scale[1] * (2 * (xy - wz)),
          scale[1] * (1 - 2 * (xx + zz)),
          scale[1] * (2 * (yz + wx)),
          scale[2] * (2 * (xz + wy)),
          scale[2] * (2 * (yz - wx)),
          scale[2] * (1 - 2 * (xx + yy)),
          translation[0],
          translation[1],
          translation[2]};
}

/// Scales a quaternion to length 1, in double. Returns false and changes nothing if its squared
/// length is farther than 1/16 from 1: quantisation to bytes changes it by at most 1/64, so such a
/// quaternion is not a rotation.
bool normalise(std::array<float, 4>& rotation);

/// Sets the last row to exactly 0 0 0 1. Returns false if it is farther than 2^-10 from that.
bool make_affine(Matrix4& matrix);

}  // namespace pelt::asset

#pragma once

#include <pelt/math.hpp>

#include "asset/quaternion.hpp"

#include <array>
#include <cmath>
#include <optional>

namespace pelt::asset {

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

}  // namespace pelt::asset

#pragma once

/// Converts joint matrices from the forms of the interface to Pelt's own.

#include <pelt/math.hpp>

#include <cstddef>
#include <span>

namespace pelt::detail {

/// Transposes, and adds the last row.
inline Matrix4 to_matrix(const Matrix3x4& rows) {
  Matrix4 matrix;
  for (std::size_t row = 0; row < 3; ++row)
    for (std::size_t column = 0; column < 4; ++column)
      matrix.m[4 * column + row] = rows.m[4 * row + column];
  return matrix;
}

/// Rounds each element to the nearest float; elements beyond the largest float become infinite.
inline Matrix4 to_matrix(std::span<const double, 16> numbers) {
  Matrix4 matrix;
  for (std::size_t i = 0; i < 16; ++i) matrix.m[i] = static_cast<float>(numbers[i]);
  return matrix;
}

}  // namespace pelt::detail

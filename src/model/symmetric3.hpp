#pragma once

#include "base/vec3.hpp"

#include <array>
#include <span>

namespace pelt::detail {

/// A symmetric 3 x 3 matrix.
struct Symmetric3 {
  double xx = 0, yy = 0, zz = 0, xy = 0, xz = 0, yz = 0;

  void add_square(const Vec3d& v) {
    xx += v.x * v.x, yy += v.y * v.y, zz += v.z * v.z;
    xy += v.x * v.y, xz += v.x * v.z, yz += v.y * v.z;
  }
};

/// Eigenvectors: three unit vectors, orthogonal up to rounding of double.
std::array<Vec3d, 3> eigenvectors(const Symmetric3& matrix);

/// The x with (matrix) x = b. Precondition: positive definite.
Vec3d solve(const Symmetric3& matrix, const Vec3d& b);

}  // namespace pelt::detail

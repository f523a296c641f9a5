#pragma once

#include <pelt/math.hpp>

#include "base/problem.hpp"

#include <cstddef>

namespace pelt::detail {

/// A rigid motion as a unit dual quaternion: the rotation q, and q multiplied from the left by half
/// the translation as a quaternion without a real part. Elements are x, y, z, w.
struct alignas(32) DualQuaternion {
  float real[4] = {0, 0, 0, 1};
  float dual[4] = {0, 0, 0, 0};
};

/// Elements of A^T A - I up to this size are rounding by an exporter: A is normalised. The same
/// limit holds for the squared length of a quaternion.
inline constexpr double kRigidTolerance = 0x1p-10;

/// Finds the rigid motion of a finite affine matrix of the joint with this number. Computed in
/// double and rounded once.
Problem to_dual_quaternion(const Matrix4& matrix, std::size_t joint, DualQuaternion& out);

/// Copies eight floats of the joint with this number, normalised: the rotation gets length one, and
/// the part of the dual quaternion that belongs to no motion is removed. Computed in double and
/// rounded once.
Problem to_dual_quaternion(const float* floats, std::size_t joint, DualQuaternion& out);

/// The matrix of the motion, computed in double and rounded once.
Matrix4 to_matrix(const DualQuaternion& motion);

}  // namespace pelt::detail

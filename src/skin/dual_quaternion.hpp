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

/// Describes why a finite affine matrix, of the joint with this number, is not rigid; empty if it
/// is.
Problem find_not_rigid(const float* matrix, std::size_t joint);

/// Describes why eight floats, of the joint with this number, are no unit dual quaternion; empty if
/// they are.
Problem find_not_unit(const float* dual, std::size_t joint);

}  // namespace pelt::detail

#pragma once

/// Validation of a file's rotations and matrices.

#include <pelt/math.hpp>

#include <array>

namespace pelt::asset {

/// Scales a quaternion to length 1, in double. Returns false and changes nothing if its squared
/// length is farther than 1/16 from 1: quantisation to bytes changes it by at most 1/64, so such a
/// quaternion is not a rotation.
bool normalise(std::array<float, 4>& rotation);

/// Sets the last row to exactly 0 0 0 1. Returns false if it is farther than 2^-10 from that.
bool make_affine(Matrix4& matrix);

}  // namespace pelt::asset

#pragma once

/// What a file's rotations and matrices must be before they are used.

#include <pelt/math.hpp>

#include <array>

namespace pelt::asset {

/// Scales a quaternion to length 1, in double. False, and unchanged, when its squared length is
/// further than 1/16 from 1: quantised to bytes a rotation is off by 1/64 at most, what is off by
/// more is no rotation.
bool normalise(std::array<float, 4>& rotation);

/// Makes the last row exactly 0 0 0 1. False when it is further than 2^-10 from that.
bool make_affine(Matrix4& matrix);

}  // namespace pelt::asset

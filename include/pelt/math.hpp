#pragma once

#include <pelt/cxx20.hpp>

#include <array>

namespace pelt {

/// A point or vector in model units. Rest positions are in the frame of the model. A joint palette
/// (one matrix per joint) transforms rest positions into posed positions. The frame of the posed
/// positions is called the frame of the joint palette. This frame is the world frame if the
/// matrices include the world matrix of the instance.
struct Vec3 {
  float x = 0, y = 0, z = 0;

  friend bool operator==(const Vec3&, const Vec3&) = default;
};

/// A joint matrix: 16 floats, column-major, with the last row 0 0 0 1. Element (row, column) is
/// `m[4 * column + row]`, and the translation is m[12], m[13], m[14].
///
/// glTF, three.js and OpenGL use the same layout, so their arrays can be passed without conversion.
/// Any affine map is allowed: rotation, translation, scale, shear, reflection.
struct Matrix4 {
  std::array<float, 16> m = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};

  friend bool operator==(const Matrix4&, const Matrix4&) = default;
};

/// The first three rows of a joint matrix: 12 floats, row-major. Element (row, column) is
/// `m[4 * row + column]`, and the translation is m[3], m[7], m[11]. The last row of the joint
/// matrix, 0 0 0 1, is not stored.
///
/// Game engines pass joint matrices to shaders in this layout (`float3x4` in HLSL). Four columns of
/// three floats are a different layout and must be transposed first.
struct Matrix3x4 {
  std::array<float, 12> m = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};

  friend bool operator==(const Matrix3x4&, const Matrix3x4&) = default;
};

static_assert(sizeof(Vec3) == 12 && sizeof(Matrix4) == 64 && sizeof(Matrix3x4) == 48,
              "arrays are shared with engines");

}  // namespace pelt

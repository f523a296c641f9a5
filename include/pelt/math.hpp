#pragma once

#include <pelt/cxx20.hpp>

#include <array>

namespace pelt {

/// A point or vector in model units. Rest positions are in the frame of the model. The matrices of
/// a joint palette transform rest positions into posed positions. The frame of posed positions is
/// called the frame of the joint palette. It is the world if the matrices include the world matrix
/// of the instance.
struct Vec3 {
  float x = 0, y = 0, z = 0;

  friend bool operator==(const Vec3&, const Vec3&) = default;
};

/// A joint matrix: 16 floats, column-major, with the last row 0 0 0 1. Element (row, column) is
/// `m[4 * column + row]`, and the translation is m[12], m[13], m[14].
///
/// This is the layout of glTF, three.js and OpenGL, so arrays of engines can be used directly. Any
/// affine map is allowed: rotation, translation, scale, shear, reflection.
struct Matrix4 {
  std::array<float, 16> m = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};

  friend bool operator==(const Matrix4&, const Matrix4&) = default;
};

/// The first three rows of a joint matrix: 12 floats, row-major; element (row, column) is
/// `m[4 * row + column]` and the translation is m[3], m[7], m[11]. The last row is 0 0 0 1.
///
/// Engines pack bones for shaders in this layout (`float3x4` in HLSL). A matrix stored column by
/// column, as four columns of three floats, has another layout and must be transposed first.
struct Matrix3x4 {
  std::array<float, 12> m = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};

  friend bool operator==(const Matrix3x4&, const Matrix3x4&) = default;
};

static_assert(sizeof(Vec3) == 12 && sizeof(Matrix4) == 64 && sizeof(Matrix3x4) == 48,
              "arrays are shared with engines");

}  // namespace pelt

#pragma once

/// Points, matrices, and simple shapes in the frame of the joint palette. All shapes are closed
/// sets. pelt/solid.hpp combines the shapes into the types `Region` and `Solid`, and declares the
/// queries of both.

#include <pelt/config.hpp>

#include <array>
#include <cstddef>
#include <span>
#include <variant>

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

/// A borrowed view of joint matrices, in one of four layouts. Arrays, vectors and spans convert to
/// it. With floats and doubles, each joint has 16 numbers in the layout of `Matrix4`. Each double
/// is rounded once, to the nearest float (ties to even), before the matrices are validated.
using JointMatrices = std::variant<std::span<const Matrix4>, std::span<const Matrix3x4>,
                                   std::span<const float>, std::span<const double>>;

/// Axis-aligned box: all points with low <= p <= high on each axis.
struct Box {
  Vec3 low, high;
};

/// All points at most `radius` from `centre`.
struct Sphere {
  Vec3 centre;
  float radius = 0;
};

/// All points at most `radius` from the segment between `a` and `b`.
struct Capsule {
  Vec3 a, b;
  float radius = 0;
};

/// All points p with normal . p <= offset. They lie behind a plane whose normal points away from
/// them. The normal may have any length.
struct HalfSpace {
  Vec3 normal;
  float offset = 0;
};

/// All points p with |axes[i] . (p - centre)| <= half[i] for i = 0, 1, 2, where half[i] is half.x,
/// half.y or half.z. If the axes are orthogonal unit vectors, this is a box with the half extents
/// `half`.
struct OrientedBox {
  Vec3 centre;
  std::array<Vec3, 3> axes = {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};
  Vec3 half;
};

/// The intersection of half-spaces, called faces. It may be unbounded or empty. The intersection of
/// no half-spaces is all of space.
class ConvexPolyhedron {
 public:
  static constexpr std::size_t kMaxFaces = 64;

  ConvexPolyhedron() = default;

  /// Copies the faces. Allocates nothing.
  ///
  /// Precondition: there are at most `kMaxFaces` faces. Otherwise the program aborts, in every
  /// build.
  PELT_API ConvexPolyhedron(std::span<const HalfSpace> faces);

  std::span<const HalfSpace> faces() const { return {faces_.data(), count_}; }

 private:
  std::array<HalfSpace, kMaxFaces> faces_ = {};
  std::size_t count_ = 0;
};

/// The view volume of a camera. The faces are left, right, bottom, top, near, far, in this order.
/// If the projection has reversed depth, `make_frustum` exchanges the last two: faces[4] is then
/// the far face, and faces[5] the near face.
struct Frustum {
  std::array<HalfSpace, 6> faces;

  /// Copies the faces, so a `Region` made from a temporary frustum stays valid.
  operator ConvexPolyhedron() const { return ConvexPolyhedron(faces); }
};

/// Range of depth between the near and the far plane after the division by w.
enum class ClipDepth {
  minus_one_to_one,  ///< OpenGL
  zero_to_one,       ///< Vulkan, Direct3D, Metal, WebGPU
};

/// Returns the frustum of the matrix projection x view: all points p whose clip coordinates (x, y,
/// z, w) = view_projection * (p, 1) satisfy |x| <= w, |y| <= w, and the limits of z that `depth`
/// selects. Each plane is rounded to float once. Reversed depth is supported. If the far plane is
/// infinite, the far face has a zero normal and excludes nothing. The far face is faces[5], or
/// faces[4] with reversed depth.
///
/// `view_projection`: column-major like a joint matrix, but its last row may have any values.
PELT_API Frustum make_frustum(const Matrix4& view_projection,
                              ClipDepth depth = ClipDepth::minus_one_to_one);

}  // namespace pelt

#pragma once

/// Plain shapes, in the frame of the joint palette like everything that queries see. All are closed
/// sets, and their numbers are taken as they are: what a query says of them is exact.

#include <pelt/cxx20.hpp>

#include <pelt/export.hpp>
#include <pelt/math.hpp>

#include <array>
#include <cstddef>
#include <span>

namespace pelt {

/// Axis-aligned and closed: all points with low <= p <= high on each axis.
struct Box {
  Vec3 low, high;
};

/// Closed: all points no further than `radius` from `centre`.
struct Sphere {
  Vec3 centre;
  float radius = 0;
};

/// All points no further than `radius` from the segment between `a` and `b`.
struct Capsule {
  Vec3 a, b;
  float radius = 0;
};

/// All points with normal . p <= offset: what lies behind a plane whose normal points out. The
/// normal may have any length.
struct HalfSpace {
  Vec3 normal;
  float offset = 0;
};

/// All points with |axes[i] . (p - centre)| <= half[i] for each i. With unit vectors at right
/// angles for axes that is a box of these half extents.
struct OrientedBox {
  Vec3 centre;
  std::array<Vec3, 3> axes = {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};
  Vec3 half;
};

/// What all half-spaces have in common; it may be unbounded or empty. Without faces: all of space.
class ConvexPolyhedron {
 public:
  static constexpr std::size_t kMaxFaces = 64;

  ConvexPolyhedron() = default;

  /// Copies the faces; allocates nothing. Precondition: at most `kMaxFaces`; more abort the
  /// program, in every build.
  PELT_API ConvexPolyhedron(std::span<const HalfSpace> faces);

  std::span<const HalfSpace> faces() const { return {faces_.data(), count_}; }

 private:
  std::array<HalfSpace, kMaxFaces> faces_ = {};
  std::size_t count_ = 0;
};

/// What a camera sees: left, right, bottom, top, near, far.
struct Frustum {
  std::array<HalfSpace, 6> faces;

  /// A copy: a `Region` made of a temporary frustum stays valid.
  operator ConvexPolyhedron() const { return ConvexPolyhedron(faces); }
};

/// What lies between the near and the far plane after the division by w.
enum class ClipDepth {
  minus_one_to_one,  ///< OpenGL
  zero_to_one,       ///< Vulkan, Direct3D, Metal, WebGPU
};

/// The frustum of projection x view: all p with |x| <= w, |y| <= w and the depth's range for the
/// clip coordinates (x, y, z, w) = view_projection (p, 1). Column-major like a joint matrix, but
/// with any last row. Each plane is rounded to float once; reversed depth is fine, and with an
/// infinite far plane that face has the normal zero and leaves nothing out.
PELT_API Frustum make_frustum(const Matrix4& view_projection,
                              ClipDepth depth = ClipDepth::minus_one_to_one);

}  // namespace pelt

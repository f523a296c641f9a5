#pragma once

/// Definition of the distance of a point and of a triangle from a triangle, which every query uses.
/// Computed in double from float32 coordinates, always with the same operations and bits.
///
/// The distance is a minimum over points of both operands, so apart from rounding it is never below
/// the real distance. Let S be the largest difference of two coordinates on an axis. The error is
/// below kDistanceError S in either direction, for triangles of any shape.
///
/// Two triangles are also never nearer than their boxes. Let g be the squared distance of the
/// boxes, computed in float. The squared distance of the triangles is at least kBoxGapShare g -
/// kBoxGapUnderflow, which is below the real g: with e = 2^-24, gaps of boxes take one rounding,
/// their squares three, and sums two more, and underflow amounts to less than 2^-147.

#include "base/vec3.hpp"
#include "geometry/triangle_pair.hpp"

#include <array>

namespace pelt::detail {

inline constexpr double kDistanceError = 0x1p-46;
inline constexpr float kBoxGapShare = 1 - 0x1p-20f, kBoxGapUnderflow = 0x1p-120f;

/// Weights of the corners of a triangle that give a point. They are not negative and sum to one up
/// to rounding.
using Barycentrics = std::array<double, 3>;

struct ClosestOnTriangle {
  double squared_distance;
  Barycentrics at;
};

ClosestOnTriangle closest_on_triangle(const Vec3d& point, const TriangleCorners& triangle);

struct ClosestPoints {
  double squared_distance;
  Barycentrics a, b;
};

/// Precondition: the triangles do not touch. (Otherwise the result is any pair of their points.)
/// Rounding can make the points nearer than `squared_distance` says.
ClosestPoints closest_points(const TriangleCorners& a, const TriangleCorners& b);

/// Returns a common point of two triangles, in the precision of double. Precondition: they touch.
ClosestPoints common_point(const TriangleCorners& a, const TriangleCorners& b);

inline Vec3d point_at(const TriangleCorners& t, const Barycentrics& at) {
  return at[0] * Vec3d(t[0]) + at[1] * Vec3d(t[1]) + at[2] * Vec3d(t[2]);
}

}  // namespace pelt::detail

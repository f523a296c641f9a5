#pragma once

#include "base/vec3.hpp"
#include "geometry/triangle_pair.hpp"

#include <array>

namespace pelt::detail {

/// *The* distance of a point and of a triangle from a triangle, by which every query measures. In
/// double, from float32 coordinates: always the same operations, so always the same bits.
///
/// The least is taken over points that both are known to have, so a result is never less than the
/// real distance but for rounding. With S the largest difference of two coordinates on an axis,
/// it is off by less than kDistanceError S either way, whatever the shape of the triangles.
inline constexpr double kDistanceError = 0x1p-46;

/// How much of each corner makes a point of a triangle. None is negative, the sum is one up to
/// rounding.
using Barycentrics = std::array<double, 3>;

struct NearestOnTriangle {
  double squared_distance;
  Barycentrics at;
};

NearestOnTriangle nearest_on_triangle(const Vec3d& point, const TriangleCorners& triangle);

struct NearestPoints {
  double squared_distance;
  Barycentrics a, b;
};

/// Precondition: the triangles do not touch. (If they do, the result is some two of their points.)
NearestPoints nearest_points(const TriangleCorners& a, const TriangleCorners& b);

/// A point that two triangles have in common, as precisely as double tells. Precondition: they
/// touch.
NearestPoints common_point(const TriangleCorners& a, const TriangleCorners& b);

inline Vec3d point_at(const TriangleCorners& t, const Barycentrics& at) {
  return at[0] * Vec3d(t[0]) + at[1] * Vec3d(t[1]) + at[2] * Vec3d(t[2]);
}

}  // namespace pelt::detail

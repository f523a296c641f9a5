#pragma once

/// Integrals of winding numbers over space as sums over triangles. By the divergence theorem, the
/// integral of a function that jumps by f from the front to the back of surfaces, and is constant
/// elsewhere, is the integral of f x . n / 3 over the surfaces, where n is the unit normal, and x
/// the position relative to any origin.
///
/// In this folder, the flux of f through a surface is six times that: for f = 1 and a triangle (p,
/// q, r), it is det(p, q, r); for f = 1 on a polygon in a plane, it is the sum of det(c, p, q) over
/// the sides (p, q) of the polygon, where c is any point of the plane.

#include "exact/exact_number.hpp"
#include "geometry/triangle_pair.hpp"

namespace pelt::detail {

using RoundedVector = Vector<Rounded>;

inline RoundedVector relative_to(const Vec3& origin, const Vec3& point) {
  return RoundedVector(point) - RoundedVector(origin);
}

/// Returns the point that divides an edge, relative to the origin.
inline RoundedVector divided(const Vec3& from, const Vec3& to, const Rounded& share,
                             const Vec3& origin) {
  const RoundedVector start = relative_to(origin, from), edge = relative_to(from, to);
  return {start.x + share * edge.x, start.y + share * edge.y, start.z + share * edge.z};
}

/// Returns the flux of 1 through a triangle. The error has the bound of OrientedPlane, with the
/// same proof.
inline Rounded flux_of(const TriangleCorners& t, const Vec3& origin) {
  const Vec3d p(t[0]), u = Vec3d(t[1]) - p, v = Vec3d(t[2]) - p, from = p - Vec3d(origin);
  return Rounded::within(dot(cross(u, v), from),
                         OrientedPlane::kRelativeError * max_abs(u) * max_abs(v) * max_abs(from));
}

}  // namespace pelt::detail

#pragma once

/// Integrals of winding numbers over space as sums over triangles. By the divergence theorem, the
/// integral of a function that jumps by f from the front to the back of surfaces, and is constant
/// elsewhere, is the integral of f x . n / 3 over the surfaces, where n is the unit normal, and x
/// the position relative to any origin.
///
/// In this folder, the flux of f through a surface is six times that: for f = 1 and a triangle (p,
/// q, r), it is det(p, q, r); for f = 1 on a polygon in a plane, it is the sum of det(c, p, q) over
/// the sides (p, q) of the polygon, where c is any point of the plane.

#include <pelt/pose.hpp>

#include "exact/exact_number.hpp"
#include "geometry/generic_ray.hpp"
#include "geometry/triangle_pair.hpp"
#include "model/surface.hpp"
#include "pose/posed_tree.hpp"
#include "query/scratch.hpp"
#include "volume/generic_crossing.hpp"

#include <span>

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

/// Returns the flux of 1 through all triangles. Precondition: all nodes are open.
Rounded surface_flux(const PosedTree& posed, const Vec3& origin);

// Two crossing triangles contribute to two fluxes: that of w_b through the surface of a, and that
// of w_a through the surface of b.
//
// On a triangle (c, d, e) of a, w_b jumps across the segments in which triangles of b cross it,
// and along the edges at their ends. Its flux through the triangle is the sum of
//
//     w_b(c) det(c, d, e)      as if w_b were constant,
//     j det(c, d, e)           for each jump j on the edge cd,
//     j (1 - t) det(c, d, e)   for each jump j on the edge de, at d + t (e - d), and
//     det(c, p, q)             for each segment pq. The inside of b is on its left.
//
// (The triangle consists of polygons with constant w_b, whose sides are parts of edges, and
// segments. If a side is part of an edge at c, det(c, p, q) = 0. For sides on de, w_b depends on
// the jumps on cd.)
//
// Segments run in the direction n_a x n_b. For the triangle of b with first corner c', a segment
// runs in the opposite direction, so it contributes det(c, p, q) - det(c', p, q) to both. The term
// with w_b(c) is added by winding_flux.

/// The contribution of two crossing triangles to the sum of both fluxes, and the turns of the
/// triangles.
struct CrossingFlux {
  Rounded flux;
  WindingTurns turns_a, turns_b;
};

/// Precondition: `crossing` is that of `a` and `b`.
CrossingFlux flux_of(const GenericCrossing& crossing, const TriangleCorners& a,
                     const TriangleCorners& b, const Vec3& origin);

/// The surface of another body, as seen from the vertices of one body.
struct OtherSurface {
  pelt::Pose& pose;

  /// The infinitesimal motion of the vertices relative to the surface.
  const GenericDirection& motion;

  /// By how much its winding number changes along triangles of the body, ascending by place.
  std::span<const WindingTurns> turns;
};

/// Returns the flux through all triangles of a body, as if on each triangle the winding number of
/// the other surface were the same as at corner 0. Precondition: there are tables of opened nodes.
Rounded winding_flux(const PosedTree& body, const OtherSurface& other, const Vec3& origin,
                     pelt::Scratch& scratch, QueryStats& work);

/// Returns the flux of w through a surface, where w is its own winding number just in front of it.
/// Divided by six, this is the integral of w (w - 1) / 2: from the front to the back of the
/// surface, where w becomes w + 1, this function grows by w. Opens all nodes. Precondition: the
/// surface is closed.
Rounded self_flux(const PosedTree& posed, const Surface& surface, Scratch& scratch,
                  QueryStats& work);

}  // namespace pelt::detail

/// Self-intersection of triangles that share corners.
///
/// Let A and B be the closed triangles, and let neither have collapsed. A and B are convex, so
/// their intersection is convex.
///
/// One shared corner v. If A and B have another common point x, both contain the segment from v to
/// x. Extend it beyond x until it leaves A or B. It leaves a triangle at the edge opposite v,
/// because it starts at v. The point where it leaves the first of the two triangles belongs to
/// both, so one opposite edge meets the other triangle. Conversely, an opposite edge does not
/// contain v, so a point of it that belongs to the other triangle is another common point.
///
/// Two shared corners u and v, third corners p of A and q of B. If q is not in the plane of A, the
/// planes cross in the line uv, and each triangle meets this line only in the shared edge. If all
/// corners are in one plane, the line uv separates the triangles if p and q are on different sides.
/// If they are on the same side, the triangles overlap: near an interior point of the edge, both
/// contain all points on that side. Neither p nor q is on the line, as neither triangle has
/// collapsed. The rule about third corners then adds nothing: p in B implies one plane and the same
/// side.
///
/// Collapsed triangles. The rules are the definition. They report a segment that passes through a
/// shared corner, or whose third corner lies on the shared edge: there, a corner or an edge of one
/// triangle lies on a part of the other that it does not share. Without the rule about third
/// corners, two segments that extend the shared edge on the same side would not be reported.

#include "self/neighbour_pair.hpp"

#include "exact/predicates.hpp"
#include "self/neighbour_by_signs.hpp"

namespace pelt::detail {

/// Whether all own corners are strictly on one side of the other triangle's plane. Decides most
/// pairs of neighbours: no rule of the table then holds. A triangle with a plane has not collapsed,
/// and the first triangle meets the plane only in the hull of the shared corners. No own corner or
/// opposite edge of the other triangle reaches this hull: a shared corner or the shared edge.
static bool is_aside(const DistinctCorners<Vec3>& part, const TriangleCorners& other) {
  if (part.own_count == 0) return false;
  const OrientedPlane plane(other[0], other[1], other[2]);
  const int side = plane.side(part.own[0]);
  return side != 0 && (part.own_count == 1 || plane.side(part.own[1]) == side);
}

bool surface_triangles_intersect(const SurfaceTriangle& a, const SurfaceTriangle& b) {
  return surface_corners_intersect<Vec3>({a.corners, a.vertices}, {b.corners, b.vertices});
}

}  // namespace pelt::detail

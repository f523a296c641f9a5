#pragma once

/// Inside and outside of closed surfaces: whether a point lies inside a body and how often the
/// surface encloses it, how deep one body is inside another, and whether one body contains another.
/// Only closed surfaces (`Surface::is_closed`) have an inside. A point is inside if the winding
/// number of the posed surface around the point is not 0. Decisions are exact on the float32 posed
/// vertices.
///
/// Volumes of closed bodies: of one body, of its overlap with itself, and of the intersection of
/// two. Surfaces may intersect themselves, because all volumes are integrals of winding numbers.
///
/// Allocation: the first query of a model also makes its surface (`SkinnedModel::surface`), unless
/// it is made already.

#include <pelt/config.hpp>

#include <pelt/distance.hpp>
#include <pelt/surface.hpp>

#include <cstdint>

namespace pelt {

enum class PointSide : std::uint8_t {
  outside,
  on,  ///< on a triangle, which may have collapsed to a segment or a point
  inside,
};

/// Writes on which side of the posed surface a point lies. Exact even if the posed surface
/// intersects itself.
///
/// Preconditions:
/// `pose`: its surface is closed. Otherwise the program aborts, in every build.
/// `point`: coordinates are between -2^60 and 2^60. A NaN or infinite coordinate aborts the
///   program, in every build.
///
/// Cost: the query first computes a box from the joint palette and the morph weights, without
/// posing vertices, in O(J). Each morph weight other than 0 adds at most O(J). If the point is in
/// the box, the query searches for a triangle that contains the point. If there is none, the query
/// casts one ray.
PELT_API QueryStats side_of(Pose& pose, const Vec3& point, Scratch& scratch, PointSide& result);

/// Writes the winding number of the posed surface around a point: how often the surface encloses
/// the point. 0 outside, 1 inside a body whose triangles are counter-clockwise seen from outside, 2
/// or more where the body overlaps itself, and negative where the surface is inside out. A point on
/// the surface has no winding number; the result is then 0, and `side_of` tells the two apart.
///
/// Preconditions and cost: as for `side_of`.
PELT_API QueryStats winding_number(Pose& pose, const Vec3& point, Scratch& scratch,
                                   std::int32_t& result);

inline constexpr std::uint32_t kNoVertex = 0xFFFFFFFF;

/// Result of `deepest_vertex`.
struct Penetration {
  /// Index of the vertex in the model of `a`. If the model has merged several vertices (see
  /// `ModelOptions::weld`), the lowest of their indices.
  std::uint32_t vertex = kNoVertex;

  Vec3 position;         ///< of the vertex
  SurfacePoint closest;  ///< closest point of the surface of `b`
  double depth = 0;      ///< distance of the vertex from that point

  /// Whether any vertex is inside.
  explicit operator bool() const { return vertex != kNoVertex; }
};

/// Writes the vertex of `a` inside `b` that is farthest from the surface of `b`. If several
/// vertices are equally deep, writes the vertex with the lowest index. The result converts to false
/// if no vertex of `a` lies inside `b`.
///
/// The depth is the one-sided Hausdorff distance from the vertices of `a` inside `b` to the surface
/// of `b`. The interior of a triangle of `a` may reach deeper than all vertices; if the triangles
/// of `a` are small, the difference is small. The depth is not the distance by which the bodies
/// must be moved to separate them.
///
/// There is no such query for a pose and itself, because all vertices of a pose lie on its own
/// surface, at depth 0. To measure how deep one closed part of a character is inside another, build
/// a model of each part. For the depth of single triangles, see `ContactTrace::depth`.
///
/// Preconditions (otherwise the program aborts, in every build):
/// `a`, `b`: different poses. The surface of `b` is closed.
///
/// Cost: tests the boxes of `a` against the surface of `b`. If the surface of `b` does not touch a
/// box, one `side_of` decides whether the box is outside `b`. Boxes outside `b` are skipped with
/// everything inside them. For each remaining vertex, the query first searches for a point of the
/// surface of `b` that is closer to the vertex than the greatest depth so far. If there is such a
/// point, the vertex is skipped. Otherwise the query tests whether the vertex is inside `b`. If so,
/// the query computes the closest point of the surface of `b`.
PELT_API QueryStats deepest_vertex(Pose& a, Pose& b, Scratch& scratch, Penetration& result);

enum class Containment : std::uint8_t {
  none,    ///< the bodies touch, or neither contains the other
  a_in_b,  ///< no triangles touch, and every connected part of `a` lies inside `b`
  b_in_a,  ///< no triangles touch, and every connected part of `b` lies inside `a`
};

/// Writes which body, if any, lies wholly inside the other body without touching it. A body whose
/// surface is not closed can be contained in the other body, but cannot contain the other body.
///
/// Precondition: `a` and `b` are different poses. Passing one pose twice aborts the program, in
/// every build.
///
/// Cost: that of `intersects`. If the bodies do not touch and the surface of `b` is closed, the
/// query then calls `side_of` for one point of each connected part of `a`, until a point is outside
/// `b`. If `a` is not inside `b`, the query does the same with `a` and `b` exchanged.
PELT_API QueryStats containment(Pose& a, Pose& b, Scratch& scratch, Containment& result);

/// A volume, in cubed units of the joint palette's frame.
struct Volume {
  double value = 0;

  /// The exact volume of the float32 posed surfaces differs from `value` by at most `error`. The
  /// bound covers all roundings.
  double error = 0;
};

/// Writes the volume that the posed surface encloses: the integral of its winding number w over
/// space. A region around which the surface winds twice counts twice. A region that the surface
/// encloses inside out, with w = -1, counts negatively, as does the whole body in a mirrored pose
/// or if its triangles are clockwise.
///
/// Error: stated in the result. About 2^-53 T times the volume of the bounding box.
///
/// Precondition: the surface of `pose` is closed. Otherwise the program aborts, in every build.
///
/// Cost: O(V + T). Opens all nodes.
PELT_API QueryStats volume(Pose& pose, Volume& result);

/// Writes the volume of the intersection of a body with itself: the integral of w (w - 1) / 2 over
/// space, where w is the winding number of the posed surface. Where the body overlaps itself once,
/// w is 2, and the region counts once. With w = 3, three pairs of layers overlap, and the region
/// counts three times. A region that is inside out, with w = -1, counts once, too. The result is 0
/// if the surface does not intersect itself, apart from the stated error.
///
/// For two bodies in one mesh, the result is the sum for both bodies plus their
/// `intersection_volume`. Exact apart from rounding, also where parts of the surface touch without
/// crossing, or coincide; docs/queries.md ("Why volumes are exact") gives the reasons.
///
/// Error: stated in the result. About 2^-53 n times the volume of a box around all triangles that
/// contribute, where n is their number: those that cross others, and those with w != 0 in front.
///
/// Precondition: the surface of `pose` is closed, and its model has at most 2^28 triangles.
/// Otherwise the program aborts, in every build.
///
/// Cost: that of `self_collide` without a filter, O(T + C log C) for C pairs of intersecting
/// triangles, and one ray for each connected part of the surface. Opens all nodes. Pairs that only
/// touch cost several times as much as others.
///
/// The first query with a model also takes 1.5 times as long as `build_self_filter`, and allocates
/// 44 to 57 bytes per triangle of a character, which copies of the model share. For
/// `Scratch::reserve`, contacts are those of `self_collide`, and pairs of triangles at a seam
/// between vertices with different influences count, too.
///
/// Source: winding numbers spread over the surface from one triangle of each connected part, as in
/// Zhou et al., "Mesh arrangements for solid geometry" (2016), but the surface is never cut.
PELT_API QueryStats self_intersection_volume(Pose& pose, Scratch& scratch, Volume& result);

/// Writes the volume of the intersection of two bodies: the integral of w_a w_b over space, where
/// w_a and w_b are the winding numbers of the posed surfaces. If neither surface intersects itself,
/// and neither is inside out, this is the volume of the points inside both bodies. Where a surface
/// overlaps itself, its winding number counts how often; with a product of winding numbers, the
/// volume is the sum of the volumes for the connected parts of `a` and `b`.
///
/// Exact apart from rounding, also where features of `a` and `b` touch without crossing, such as
/// two faces in one plane; docs/queries.md ("Why volumes are exact") gives the reasons.
///
/// Error: stated in the result. About 2^-53 n times the volume of a box around all triangles that
/// contribute, where n is their number. Exchanging `a` and `b` may change the result within the
/// stated errors.
///
/// Precondition: `a` and `b` are different poses, and their surfaces are closed. Otherwise the
/// program aborts, in every build.
///
/// Cost: that of `collide`, and O(C log C) for C pairs of intersecting triangles. The query then
/// tests the boxes of each body against the surface of the other body, and casts one ray for each
/// box that does not touch the surface. Boxes outside are skipped with everything inside them.
/// Everything else is posed, because each of its triangles contributes.
///
/// Source: integrals along edges and segments of intersection, as in W. R. Franklin, "Polygon
/// properties calculated from the vertex neighborhoods" (1987). No polyhedron is constructed.
PELT_API QueryStats intersection_volume(Pose& a, Pose& b, Scratch& scratch, Volume& result);

}  // namespace pelt

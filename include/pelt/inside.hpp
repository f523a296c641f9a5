#pragma once

/// Inside and outside of closed surfaces: whether a point lies inside a body and how often the
/// surface encloses it, how deep one body is inside another, and whether one body contains another.
/// Only closed surfaces
/// (`Surface::is_closed`) have an inside. A point is inside if the winding number of the posed
/// surface around the point is not 0. Decisions are exact on the float32 posed vertices.

#include <pelt/cxx20.hpp>

#include <pelt/contact.hpp>
#include <pelt/distance.hpp>
#include <pelt/export.hpp>

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
/// `surface`: closed, and of the model of `pose`. Otherwise the program aborts, in every build.
/// `point`: coordinates are between -2^60 and 2^60. A NaN or infinite coordinate aborts the
///   program, in every build.
///
/// Cost: the query first computes a box from the joint palette and the morph weights, without
/// posing vertices, in O(J). Each morph weight other than 0 adds at most O(J). If the point is in
/// the box, the query searches for a triangle that contains the point. If there is none, the query
/// casts one ray.
PELT_API QueryStats side_of(Pose& pose, const Surface& surface, const Vec3& point, Scratch& scratch,
                            PointSide& result);

/// Writes the winding number of the posed surface around a point: how often the surface encloses
/// the point. 0 outside, 1 inside a body whose triangles are counter-clockwise seen from outside, 2
/// or more where the body overlaps itself, and negative where the surface is inside out. A point on
/// the surface has no winding number; the result is then 0, and `side_of` tells the two apart.
///
/// Preconditions and cost: as for `side_of`.
PELT_API QueryStats winding_number(Pose& pose, const Surface& surface, const Vec3& point,
                                   Scratch& scratch, std::int32_t& result);

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
/// `a`, `b`: different poses.
/// `surface_a`, `surface_b`: surfaces of the models of `a` and `b`; `surface_b` is closed.
///
/// Cost: tests the boxes of `a` against the surface of `b`. If the surface of `b` does not touch a
/// box, one `side_of` decides whether the box is outside `b`. Boxes outside `b` are skipped with
/// everything inside them. For each remaining vertex, the query first searches for a point of the
/// surface of `b` that is closer to the vertex than the greatest depth so far. If there is such a
/// point, the vertex is skipped. Otherwise the query tests whether the vertex is inside `b`. If so,
/// the query computes the closest point of the surface of `b`.
PELT_API QueryStats deepest_vertex(Pose& a, const Surface& surface_a, Pose& b,
                                   const Surface& surface_b, Scratch& scratch, Penetration& result);

enum class Containment : std::uint8_t {
  none,    ///< the bodies touch, or neither contains the other
  a_in_b,  ///< no triangles touch, and every connected part of `a` lies inside `b`
  b_in_a,  ///< no triangles touch, and every connected part of `b` lies inside `a`
};

/// Writes which body, if any, lies wholly inside the other body without touching it. A body whose
/// surface is not closed can be contained in the other body, but cannot contain the other body.
///
/// Preconditions: as for `deepest_vertex`, but `surface_b` need not be closed.
///
/// Cost: that of `intersects`. If the bodies do not touch and `surface_b` is closed, the query then
/// calls `side_of` for one point of each connected part of `a`, until a point is outside `b`. If
/// `a` is not inside `b`, the query does the same with `a` and `b` exchanged.
PELT_API QueryStats containment(Pose& a, const Surface& surface_a, Pose& b,
                                const Surface& surface_b, Scratch& scratch, Containment& result);

}  // namespace pelt

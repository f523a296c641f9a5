#pragma once

/// Inside and outside of closed surfaces: whether a point lies inside a body, how deep one body is
/// inside another, and whether one body contains another. Only closed surfaces
/// (`Surface::is_closed`) have an inside. A point is inside if the winding number of the posed
/// surface around it is not 0. Decisions are exact on the float32 posed vertices.

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

/// Writes on which side of the surface a point lies. Exact for any posed vertices.
///
/// Preconditions:
/// `surface`: closed, and of the model of `pose`. Otherwise the program aborts, in every build.
/// `point`: coordinates are finite and at most 2^60. A NaN or infinite coordinate aborts the
///   program, in every build.
///
/// Cost: a search for triangles that contain the point and, if there are none, one ray. Neither is
/// needed if the point is outside the box that is computed from the joint palette alone.
PELT_API QueryStats side_of(Pose& pose, const Surface& surface, const Vec3& point, Scratch& scratch,
                            PointSide& result);

inline constexpr std::uint32_t kNoVertex = 0xFFFFFFFF;

/// Result of `deepest_vertex`.
struct Penetration {
  /// Index of the vertex in the model of `a`. If several vertices are bit-identical (see
  /// `Surface::is_closed`), the lowest of their indices.
  std::uint32_t vertex = kNoVertex;

  Vec3 position;         ///< of the vertex
  SurfacePoint closest;  ///< closest point of the surface of the second body
  double depth = 0;      ///< distance of the vertex from that point

  /// Whether any vertex is inside.
  explicit operator bool() const { return vertex != kNoVertex; }
};

/// Writes the vertex of `a` that lies inside `b` and is farthest from the surface of `b`. Of
/// equally deep vertices, the one with the lowest index is written. The result converts to false if
/// no vertex of `a` lies inside `b`.
///
/// The depth is the one-sided Hausdorff distance from the vertices of `a` inside `b` to the surface
/// of `b`. Between its vertices, the surface of `a` may reach deeper, but not by much if the
/// triangles of `a` are small. The depth is not the distance by which the bodies must be moved to
/// separate them.
///
/// A pose has no deepest vertex in itself: all its vertices lie on its surface, at depth 0. Where a
/// closed surface overlaps itself, the winding number is 2 instead of 1, and both are inside. For
/// one closed part of a character in another, build a model of each part. For single triangles, see
/// `ContactTrace::depth`.
///
/// Preconditions (otherwise the program aborts, in every build):
/// `a`, `b`: different poses.
/// `surface_a`, `surface_b`: surfaces of the models of `a` and `b`; `surface_b` is closed.
///
/// Cost: tests the boxes of `a` against the surface of `b`. If the surface does not touch a box,
/// one `side_of` decides whether the box is outside `b`. Nothing in a box outside `b` is opened or
/// tested. For each remaining vertex, the query first searches for a point of the surface of `b`
/// that is closer than the greatest depth so far. If there is such a point, the vertex is skipped.
/// Otherwise the query tests whether the vertex is inside `b`, and computes its closest point.
PELT_API QueryStats deepest_vertex(Pose& a, const Surface& surface_a, Pose& b,
                                   const Surface& surface_b, Scratch& scratch, Penetration& result);

enum class Containment : std::uint8_t {
  none,    ///< the bodies touch, or neither contains the other
  a_in_b,  ///< no triangles touch, and every connected part of `a` lies inside `b`
  b_in_a,
};

/// Writes which body lies wholly inside the other without touching it. A body whose surface is not
/// closed can be contained in the other body, but cannot contain it.
///
/// Preconditions: as for `deepest_vertex`, but `surface_b` need not be closed.
///
/// Cost: that of `intersects`. If the bodies do not touch and `surface_b` is closed, the query
/// calls `side_of` for one point of each connected part of `a`, until a point is outside `b`.
/// Unless `a` is inside `b`, the query then tests `b` against `a` in the same way.
PELT_API QueryStats containment(Pose& a, const Surface& surface_a, Pose& b,
                                const Surface& surface_b, Scratch& scratch, Containment& result);

}  // namespace pelt

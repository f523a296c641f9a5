#pragma once

/// Inside and outside: whether a point lies in a body, how deep one body is in another, whether one
/// holds another whole. All of it is about closed surfaces (`Surface::is_closed`), which alone have
/// an inside: the points around which the posed surface winds, in either direction and however
/// often. What is decided is decided exactly on the float32 posed vertices.

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

/// Writes where a point lies, exactly, for any posed vertices. Preconditions: the surface is closed
/// and of the pose's model (otherwise the program aborts, in every build); the coordinates of
/// `point` are finite and at most 2^60. Cost: a search for the triangles that contain the point,
/// and one ray.
PELT_API QueryStats side_of(Pose& pose, const Surface& surface, const Vec3& point, Scratch& scratch,
                            PointSide& result);

inline constexpr std::uint32_t kNoVertex = 0xFFFFFFFF;

/// The answer of `deepest_vertex`.
struct Penetration {
  std::uint32_t vertex = kNoVertex;  ///< of the first body, the lowest of those alike in every bit
  Vec3 position;                     ///< of it
  SurfacePoint closest;              ///< of the second body's surface
  double depth = 0;                  ///< how far that is from the vertex

  /// Whether any vertex is inside.
  explicit operator bool() const { return vertex != kNoVertex; }
};

/// Writes the vertex of `a` that lies inside `b` and is farthest from its surface; of equal ones
/// the lowest. The result is false where no vertex of `a` is inside.
///
/// The depth is the one-sided Hausdorff distance of the vertices inside `b` to its surface: a lower
/// bound of how far the surface of `a` reaches in, which no triangulation makes smaller when it
/// cuts triangles, and which becomes that when they become small. It is not the way by which bodies
/// must be moved to part them.
///
/// Preconditions: `surface_a` and `surface_b` are of the models of `a` and `b`, which are different
/// poses; `surface_b` is closed; otherwise the program aborts, in every build. Boxes of `a` that
/// the surface of `b` does not touch cost a few rays each, and what is outside is not posed; each
/// other vertex costs a search for something nearer than the deepest so far, and those that have
/// nothing such near, some rays.
PELT_API QueryStats deepest_vertex(Pose& a, const Surface& surface_a, Pose& b,
                                   const Surface& surface_b, Scratch& scratch, Penetration& result);

enum class Containment : std::uint8_t {
  none,    ///< they touch, or no body holds the other whole
  a_in_b,  ///< no triangles touch, and every part of `a` that hangs together is inside `b`
  b_in_a,
};

/// Writes whether one body is wholly inside the other, which no contact tells. A surface that is
/// not closed holds nothing, but may be held. Preconditions: as for `deepest_vertex`, but that
/// surfaces need not be closed. Costs what `intersects` does, and some rays for each part that
/// hangs together.
PELT_API QueryStats containment(Pose& a, const Surface& surface_a, Pose& b,
                                const Surface& surface_b, Scratch& scratch, Containment& result);

}  // namespace pelt

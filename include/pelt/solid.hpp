#pragma once

/// Posed skins and simple solids: which triangles touch a solid or lie inside it, on which side of
/// it the skin lies, how far the skin is from it, and where a ray enters it. For culling,
/// selection, triggers, and characters against simple solids.
///
/// `Region` and `Solid` are two types because distances and rays do not support a ConvexPolyhedron.

#include <pelt/cxx20.hpp>

#include <pelt/distance.hpp>
#include <pelt/export.hpp>
#include <pelt/pose.hpp>
#include <pelt/query.hpp>
#include <pelt/ray.hpp>
#include <pelt/shapes.hpp>

#include <cstdint>
#include <limits>
#include <span>
#include <variant>
#include <vector>

namespace pelt {

/// A part of space: a closed convex set of points, stored by value.
///
/// Preconditions of queries: all numbers are finite, and radii and half extents are not negative.
/// Otherwise the program aborts, in every build.
using Region = std::variant<HalfSpace, Box, OrientedBox, ConvexPolyhedron, Sphere, Capsule>;

/// Position of the posed surface, which is the union of all triangles, relative to a region.
enum class Placement : std::uint8_t {
  outside,  ///< no triangle touches the region
  partly,   ///< some triangle touches the region, and some triangle is not wholly inside
  inside,   ///< all triangles lie wholly in the region
};

/// Returns "outside", "partly" or "inside".
PELT_API const char* name_of(Placement placement);

/// Writes whether the posed surface lies outside, partly inside or wholly inside a region.
///
/// Exact with respect to the float32 posed vertices and the region's own numbers, both taken as
/// real numbers. Triangles and regions are closed sets, so touching counts; a triangle that has
/// collapsed is a segment or a point. A filter in double with running error bounds decides nearly
/// every triangle, and exact arithmetic the rest.
///
/// Cost: O(J) if the box from the joint palette decides, which it nearly always does for a frustum.
/// Otherwise nodes along the boundary of the region are opened until the answer is known.
PELT_API QueryStats classify(Pose& pose, const Region& region, Scratch& scratch, Placement& result);

/// Classifies many poses: `results[i]` belongs to `*poses[i]`. Returns the work of all poses.
///
/// Precondition: `results` has one element per pose. Otherwise the program aborts, in every build.
PELT_API QueryStats classify(std::span<Pose* const> poses, const Region& region, Scratch& scratch,
                             std::span<Placement> results);

/// Triangles of one pose in a region, as indices into the triangle array of the model.
struct TrianglesInRegion {
  std::vector<std::uint32_t> intersecting;  ///< share at least one point with the region
  std::vector<std::uint32_t> inside;        ///< lie wholly in the region; also in the first list
};

/// Appends the triangles that intersect the region to one list, and those inside it to the other
/// list, both in ascending order. Exact like `classify`.
///
/// Cost: opens nodes along the boundary of the region. Parts wholly inside are not posed.
PELT_API QueryStats find_triangles(Pose& pose, const Region& region, Scratch& scratch,
                                   TrianglesInRegion& triangles);

/// Appends the triangles that intersect the region, in ascending order. Triangles wholly inside
/// intersect the region, too. Like `find_triangles`, but without the second list.
PELT_API QueryStats collide(Pose& pose, const Region& region, Scratch& scratch,
                            std::vector<std::uint32_t>& triangles);

/// Returns whether any triangle intersects the region. Like `collide`, but stops at the first.
PELT_API YesNo intersects(Pose& pose, const Region& region, Scratch& scratch);

/// A simple solid: a region for which Pelt can also compute distances and cast rays.
///
/// Preconditions of queries: as for `Region`; the normal of a half-space is not zero; the low
/// corner of a box is not above its high corner on any axis. Otherwise the program aborts, in every
/// build. In addition, the axes of an oriented box are linearly independent, which is not checked.
using Solid = std::variant<HalfSpace, Box, OrientedBox, Sphere, Capsule>;

/// Result of `distance` from a solid.
struct SolidDistance {
  /// Infinite if nothing is within `max_distance`; the points are then meaningless.
  double distance = std::numeric_limits<double>::infinity();
  SurfacePoint surface;  ///< point of the posed skin
  Vec3 solid;            ///< closest point of the solid, rounded to float

  /// Whether anything was found.
  explicit operator bool() const { return distance < std::numeric_limits<double>::infinity(); }
};

/// Writes the least distance of any posed triangle from a solid, with two points at this distance.
///
/// The distance is 0 if and only if some triangle touches the solid as in `collide`, which is
/// decided exactly; triangles inside the solid touch it. If any triangle touches the solid, the
/// touching triangle with the lowest index is reported. The two points in `result` are then equal:
/// a point that belongs to the triangle and to the solid. Otherwise the distance is computed in
/// double and is positive. Of equally distant triangles, the one with the lowest index is reported.
///
/// Error: less than 2^-45 c, where c is the largest absolute coordinate of the posed vertices and
/// of the solid's surface. A half-space has an unbounded surface and contributes |offset| /
/// |normal| to c instead. For an oriented box, the error is less than 2^-22 c, because the corners
/// of the box are rounded to float.
///
/// Cost: visits the closest boxes first, like `closest_point`. If the skin touches the solid, the
/// query costs as much as `collide`.
PELT_API QueryStats distance(Pose& pose, const Solid& solid, Scratch& scratch,
                             SolidDistance& result, const ClosestPointOptions& options = {});

/// Where a ray enters a solid.
struct SolidHit {
  float t = std::numeric_limits<float>::infinity();
  Vec3 normal;  ///< unit normal out of the solid; zero if the ray is already inside at t_min

  /// Whether anything was hit.
  explicit operator bool() const { return t < std::numeric_limits<float>::infinity(); }
};

/// Writes the first point of the ray in the solid. A ray with the direction zero hits the solid if
/// its origin is inside. The returned work is zero, because a solid has no tree.
///
/// Error: unlike hits on triangles, hits on solids are not exact. t is computed in double and then
/// rounded to float. Before this rounding, the point where the ray enters is off the surface of the
/// solid by less than 2^-40 c, where c is the largest absolute coordinate of the ray's origin and
/// of the solid's surface (for a half-space, as in `distance`). A ray that passes the solid within
/// this distance may count as hit or as missed.
///
/// Preconditions:
/// `solid`: see `Solid`.
/// `ray`: see `Ray`. In addition, t_min is finite. Otherwise the program aborts, in every build.
///
/// Cost: O(1). Allocates nothing.
PELT_API QueryStats cast(const Solid& solid, const Ray& ray, SolidHit& result);

}  // namespace pelt

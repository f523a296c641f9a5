#pragma once

/// Which posed skins, and which of their triangles, are in a region of space: for culling,
/// selection, triggers, and characters against simple solids.

#include <pelt/cxx20.hpp>

#include <pelt/export.hpp>
#include <pelt/pose.hpp>
#include <pelt/query.hpp>
#include <pelt/shapes.hpp>

#include <cstdint>
#include <span>
#include <variant>
#include <vector>

namespace pelt {

/// A closed convex set of points, stored by value. Preconditions of queries: its numbers are
/// finite, and radii and half extents are not negative. Builds without NDEBUG check them.
using Region = std::variant<HalfSpace, Box, OrientedBox, ConvexPolyhedron, Sphere, Capsule>;

/// Where the posed surface, the union of all triangles, lies.
enum class Placement : std::uint8_t {
  outside,  ///< no triangle touches the region
  partly,   ///< some triangle touches the region, and some triangle is not wholly inside
  inside,   ///< all triangles lie wholly in the region
};

/// Returns "outside", "partly" or "inside".
PELT_API const char* name_of(Placement placement);

/// Writes where the posed surface lies.
///
/// Exact with respect to the float32 posed vertices and the region's own numbers, both taken as
/// real numbers. Triangles and regions are closed sets, so touching counts; a triangle that has
/// collapsed is a segment or a point. A filter in double with running error bounds decides nearly
/// every triangle, and exact arithmetic the rest.
///
/// Cost: O(J) if the box from the joint palette decides, which it nearly always does for a frustum.
/// Otherwise nodes along the boundary of the region are opened until the answer is known.
PELT_API QueryStats classify(Pose& pose, const Region& region, Scratch& scratch, Placement& result);

/// Classifies many poses: `results[i]` belongs to `*poses[i]`. Returns the work of all.
///
/// Precondition: `results` has one element per pose.
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

/// Appends the triangles that intersect the region, in ascending order: contacts of a character
/// with a simple solid. Like `find_triangles`; a region is a solid, so triangles wholly inside
/// intersect it, too.
PELT_API QueryStats collide(Pose& pose, const Region& region, Scratch& scratch,
                            std::vector<std::uint32_t>& triangles);

/// Returns whether any triangle intersects the region. Like `collide`, but stops at the first.
PELT_API YesNo intersects(Pose& pose, const Region& region, Scratch& scratch);

}  // namespace pelt

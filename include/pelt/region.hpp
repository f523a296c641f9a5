#pragma once

/// Which posed skins, and which of their triangles, are in a region of space: culling, selection,
/// triggers, a character against simple solids.

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

/// A closed set of points that is convex, and owns its numbers. They must be finite, radii and half
/// extents not negative.
using Region = std::variant<HalfSpace, Box, OrientedBox, ConvexPolyhedron, Sphere, Capsule>;

/// Where the posed surface lies, that is, the union of all triangles.
enum class Placement : std::uint8_t {
  outside,  ///< no triangle touches the region
  partly,   ///< some triangle touches it, and some is not wholly inside
  inside,   ///< all triangles lie wholly in it
};

/// "outside", "partly" or "inside".
PELT_API const char* name_of(Placement placement);

/// Writes where the posed surface lies.
///
/// Exact with respect to the float32 posed vertices and the region's own numbers, both taken as
/// real numbers: triangles and regions are closed sets, so touching counts, and a triangle that has
/// collapsed is the segment or point that it is. A double filter with running error bounds decides
/// nearly every triangle, exact arithmetic the rest.
///
/// Costs O(J) where the box from the joint palette tells, which is nearly always in a frustum; else
/// nodes are opened along the region's boundary until one triangle inside or across it and one
/// outside or across it are found.
PELT_API QueryStats classify(Pose& pose, const Region& region, Scratch& scratch, Placement& result);

/// The same for many poses: `results[i]` is that of `*poses[i]`. Precondition: `results` has one
/// element for each pose. Returns the work of all.
PELT_API QueryStats classify(std::span<Pose* const> poses, const Region& region, Scratch& scratch,
                             std::span<Placement> results);

/// The triangles of one pose that are in a region, by their numbers in the model's array.
struct TrianglesInRegion {
  std::vector<std::uint32_t> intersecting;  ///< have at least a point in common with it
  std::vector<std::uint32_t> inside;        ///< of these, those that lie wholly in it
};

/// Appends the triangles that intersect the region to one list and those inside it to the other,
/// both ascending. Exact as `classify`. Nodes are opened along the region's boundary; what is
/// inside is not even posed.
PELT_API QueryStats find_triangles(Pose& pose, const Region& region, Scratch& scratch,
                                   TrianglesInRegion& triangles);

/// Appends the triangles that intersect the region, ascending: the character meets a simple solid.
/// As `find_triangles`: a region is a solid, so what lies wholly inside intersects it too.
PELT_API QueryStats collide(Pose& pose, const Region& region, Scratch& scratch,
                            std::vector<std::uint32_t>& triangles);

/// Whether any triangle intersects the region; as `collide`, stopping at the first.
PELT_API YesNo intersects(Pose& pose, const Region& region, Scratch& scratch);

}  // namespace pelt

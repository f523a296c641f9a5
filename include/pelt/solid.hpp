#pragma once

/// Tests of a posed skin against a region of space or a solid, and rays against a solid. The
/// queries find the triangles that touch or lie inside, now or at any time of a step, decide
/// whether the skin is inside or outside, and compute its distance from a solid. Use them for
/// culling, selection, triggers, and collisions of characters with simple obstacles.
///
/// `Region` and `Solid` are two types because distances and rays do not support a ConvexPolyhedron.

#include <pelt/config.hpp>

#include <pelt/distance.hpp>
#include <pelt/math.hpp>
#include <pelt/motion.hpp>
#include <pelt/pose.hpp>
#include <pelt/query.hpp>
#include <pelt/ray.hpp>

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

/// Position of the posed surface relative to a region. The surface is the union of all posed
/// triangles.
enum class Placement : std::uint8_t {
  outside,  ///< no triangle touches the region
  partly,   ///< some triangle touches the region, and some triangle is not wholly in the region
  inside,   ///< all triangles lie wholly in the region
};

/// Returns "outside", "partly" or "inside".
PELT_API const char* name_of(Placement placement);

/// Writes whether the posed surface lies outside, partly inside or wholly inside a region.
///
/// The answer is exact with respect to the float32 posed vertices and the float32 numbers of the
/// region. Triangles and regions are closed sets, so touching counts. A triangle that has collapsed
/// to a segment or a point is treated as that segment or point. A filter in double precision with
/// running error bounds decides nearly all triangles. Exact arithmetic decides the others.
///
/// Cost: the query first computes a box from the joint palette and the morph weights, without
/// posing vertices, in O(J). Each morph weight other than 0 adds at most O(J). The box nearly
/// always decides the answer for a frustum. Otherwise the query opens nodes along the boundary of
/// the region until the answer is known.
PELT_API QueryStats classify(Pose& pose, const Region& region, Scratch& scratch, Placement& result);

/// Classifies many poses, and writes the placement of `*poses[i]` to `results[i]`. Returns the work
/// for all poses.
///
/// Precondition: `results` has one element per pose. Otherwise the program aborts, in every build.
PELT_API QueryStats classify(std::span<Pose* const> poses, const Region& region, Scratch& scratch,
                             std::span<Placement> results);

/// Triangles of one pose in a region, as indices into the triangle array of the model.
struct TrianglesInRegion {
  std::vector<std::uint32_t> intersecting;  ///< share at least one point with the region
  std::vector<std::uint32_t> inside;        ///< lie wholly in the region; also in the first list
};

/// Appends the triangles that intersect the region to `triangles.intersecting`, and those that lie
/// wholly in the region to `triangles.inside`, both in ascending order. Exact like `classify`.
///
/// Cost: opens nodes along the boundary of the region. Nodes that lie wholly in the region are not
/// posed.
PELT_API QueryStats find_triangles(Pose& pose, const Region& region, Scratch& scratch,
                                   TrianglesInRegion& triangles);

/// Appends the triangles that intersect the region, in ascending order. Like `find_triangles`, but
/// without the list `inside`.
PELT_API QueryStats collide(Pose& pose, const Region& region, Scratch& scratch,
                            std::vector<std::uint32_t>& triangles);

/// Returns whether any triangle intersects the region. Like `collide`, but stops at the first.
PELT_API YesNo intersects(Pose& pose, const Region& region, Scratch& scratch);

/// A triangle that touches a region at some time of a step.
struct RegionEntry {
  std::uint32_t triangle = 0;  ///< index into the triangle array of the model

  /// The largest float that is not above the first time at which the triangle touches the region, 0
  /// to 1. The triangle is apart from the region at all earlier times.
  float time = 0;

  bool at_start = false;  ///< whether the triangle touches the region at time 0

  friend bool operator==(const RegionEntry&, const RegionEntry&) = default;
};

/// Appends every triangle of the moving skin that touches the region at any time from 0 to 1, in
/// ascending order. The region stands still. A triangle that is inside the region touches it.
///
/// Options are those of `collide` of two motions. A triangle counts as a contact. Without
/// `times`, each entry has time 0, and `at_start` is false.
///
/// The answer is exact with respect to the float32 posed vertices at both ends, to real numbers
/// between them, and to the float32 numbers of the region. At each time, triangles touch the region
/// as defined at `classify`.
///
/// Preconditions: those of `Motion` and `Region`; `scratch` is not used by another thread at the
/// same time.
///
/// Cost: as `collide` of a pose, but nodes are opened in both poses. A search in double precision
/// with error bounds decides nearly all triangles that boxes and the ends of the step leave
/// undecided, in a few microseconds each. Exact arithmetic decides the others, in about 100 us each
/// and with up to 900 KB of the stack: triangles that touch the region only at a single time, and
/// triangles that move through a box or polyhedron without thickness.
///
/// Allocates only if it needs more memory in the poses, in `scratch` or in `entries` than any
/// earlier query.
PELT_API MovingStats collide(const Motion& motion, const Region& region, Scratch& scratch,
                             std::vector<RegionEntry>& entries, const MovingOptions& options = {});

/// Returns whether any triangle of the moving skin touches the region at any time. Like
/// `collide` without `times`, but stops at the first triangle that it finds.
PELT_API YesNo intersects(const Motion& motion, const Region& region, Scratch& scratch);

/// A simple solid: a region for which Pelt can also compute distances and cast rays.
///
/// Preconditions of queries: as for `Region`. In addition, the normal of a half-space is not zero,
/// and a box has low <= high on each axis. Otherwise the program aborts, in every build. The axes
/// of an oriented box must be linearly independent; this is not checked.
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

/// Writes the least distance of any posed triangle from a solid, and two points at this distance:
/// one of the skin, one of the solid.
///
/// The distance is 0 if and only if some triangle touches the solid as in `collide`, which is
/// decided exactly. A triangle inside the solid touches the solid. If the distance is 0, the
/// touching triangle with the lowest index is reported, and the two points are equal: a point that
/// belongs to this triangle and to the solid. Otherwise the distance is computed in double
/// precision and is positive. Of triangles whose computed distances are equal, the one with
/// the lowest index is reported.
///
/// Error: less than 2^-45 c, where c is the largest absolute coordinate of the posed vertices and
/// of the solid's surface. A half-space has an unbounded surface, so |offset| / |normal| is used
/// instead of the coordinates of its surface. For an oriented box, the error is less than 2^-22 c,
/// because the corners of the box are rounded to float.
///
/// Cost: visits the closest boxes first, like `closest_point`. If the skin touches the solid, the
/// query costs as much as `collide`.
PELT_API QueryStats distance(Pose& pose, const Solid& solid, Scratch& scratch,
                             SolidDistance& result, const Limits& limits = {});

/// Where a ray enters a solid. If the ray does not hit the solid, t is infinite.
struct SolidHit {
  float t = std::numeric_limits<float>::infinity();

  /// Unit normal out of the solid where the ray enters. Zero if the ray misses, or is already
  /// inside at t_min. Spheres and capsules with radius 0 have no unique normal: the result points
  /// against the ray.
  Vec3 normal;

  /// Whether anything was hit.
  explicit operator bool() const { return t < std::numeric_limits<float>::infinity(); }
};

/// Writes the first point of the ray in the solid. If the ray is already in the solid at t_min, t
/// is t_min. A ray with the direction zero hits the solid if its origin is inside. The returned
/// work is zero, because a solid has no tree.
///
/// Error: unlike hits on triangles, hits on solids are not exact. t is computed in double precision
/// and then rounded to float. Before this rounding, the computed point of entry is off the surface
/// of the solid by less than 2^-40 c, where c is the largest absolute coordinate of the ray's
/// origin and of the solid's surface (for a half-space, see `distance`). A ray that passes the
/// solid within this distance may count as hit or as missed.
///
/// Preconditions:
/// `solid`: see `Solid`.
/// `ray`: see `Ray`. In addition, t_min is finite. Otherwise the program aborts, in every build.
///
/// Cost: O(1). Allocates nothing.
PELT_API QueryStats cast(const Solid& solid, const Ray& ray, SolidHit& result);

}  // namespace pelt

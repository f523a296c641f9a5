#pragma once

/// Distance from a character to simple solids, and rays against them. For touching see `collide`;
/// for inside and outside, `classify` (pelt/region.hpp).

#include <pelt/cxx20.hpp>

#include <pelt/distance.hpp>
#include <pelt/export.hpp>
#include <pelt/ray.hpp>
#include <pelt/shapes.hpp>

#include <limits>
#include <variant>

namespace pelt {

/// A simple solid. Numbers must be finite. The normal of a half-space must not be zero, radii and
/// half extents must not be negative, the low corner of a box must not be above its high corner,
/// and the axes of an oriented box must span space.
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
/// decided exactly; triangles inside the solid touch it. The lowest such triangle is then reported,
/// and both points are a common point of triangle and solid. Otherwise the distance is computed in
/// double and is positive. Of equally distant triangles, the lowest is reported.
///
/// Error: less than 2^-45 times the largest coordinate in the query (including a half-space's
/// offset for a unit normal). For an oriented box, the error is less than 2^-22 times that
/// coordinate, because the corners of the box are rounded to float.
///
/// Cost: opens nodes nearest first, like `closest_point`. A skin that touches costs as much as
/// `collide`.
PELT_API QueryStats distance(Pose& pose, const Solid& solid, Scratch& scratch,
                             SolidDistance& result, const ClosestPointOptions& options = {});

/// Where a ray enters a solid.
struct SolidHit {
  float t = std::numeric_limits<float>::infinity();
  Vec3 normal;  ///< unit normal out of the solid; zero if the ray is already inside at t_min

  /// Whether anything was hit.
  explicit operator bool() const { return t < std::numeric_limits<float>::infinity(); }
};

/// Writes the first point of the ray in the solid. The returned work is zero, because a solid has
/// no tree.
///
/// Error: unlike hits on triangles, the hit is computed in double. It is off the surface of the
/// solid by less than 2^-40 times the largest coordinate in the query, apart from the rounding of
/// t. A ray that passes the solid within this distance may count as hit or as missed.
///
/// Preconditions: those of the solid and of rays; t_min is finite.
PELT_API QueryStats cast(const Solid& solid, const Ray& ray, SolidHit& result);

}  // namespace pelt

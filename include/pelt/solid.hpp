#pragma once

/// Simple solids that a character is some way from, and that stand in the way of rays. What touches
/// them `collide` tells, and which side of them things are on `classify` (pelt/region.hpp).

#include <pelt/cxx20.hpp>

#include <pelt/distance.hpp>
#include <pelt/export.hpp>
#include <pelt/ray.hpp>
#include <pelt/shapes.hpp>

#include <limits>
#include <variant>

namespace pelt {

/// Numbers are finite. A half-space's normal is not zero, radii and half extents are not negative,
/// a box's low corner is not above its high one, and an oriented box's axes span space.
using Solid = std::variant<HalfSpace, Box, OrientedBox, Sphere, Capsule>;

/// The answer of `distance` from a solid.
struct SolidDistance {
  /// Infinite if nothing is within the maximum; the points then have no meaning.
  double distance = std::numeric_limits<double>::infinity();
  SurfacePoint surface;  ///< of the posed skin
  Vec3 solid;            ///< the point of the solid that is closest to it, rounded to float

  /// Whether anything was found.
  explicit operator bool() const { return distance < std::numeric_limits<double>::infinity(); }
};

/// Writes the least distance of any posed triangle from a solid, and two points that have it.
///
/// It is 0 if and only if some triangle touches the solid as `collide` decides it, exactly; what is
/// inside touches. The lowest of those triangles then counts, and both points are one that it has
/// in common with the solid. Otherwise it is computed in double, is positive, and is off by less
/// than 2^-45 times the largest coordinate in the query (and a half-space's offset, for a normal of
/// length one); of an oriented box by 2^-22 times that, because its corners are rounded to float.
/// Of triangles that are equally far the lowest counts.
///
/// Nodes are opened nearest first, as for the closest point; a skin that touches costs what
/// `collide` does.
PELT_API QueryStats distance(Pose& pose, const Solid& solid, Scratch& scratch,
                             SolidDistance& result, const ClosestPointOptions& options = {});

/// Where a ray enters a solid.
struct SolidHit {
  float t = std::numeric_limits<float>::infinity();
  Vec3 normal;  ///< out of the solid, of length 1; zero where the ray begins inside, at t_min

  /// Whether anything was hit.
  explicit operator bool() const { return t < std::numeric_limits<float>::infinity(); }
};

/// Writes the first point of the ray that is in the solid. Returns no work: a solid has no tree.
/// Computed in double, unlike what triangles are hit: the place is off the solid's surface by less
/// than 2^-40 times the largest coordinate in the query, but for the rounding of t, and a ray that
/// passes as near by may count either way. Preconditions: as for the solid, and for rays; t_min is
/// finite.
PELT_API QueryStats cast(const Solid& solid, const Ray& ray, SolidHit& result);

}  // namespace pelt

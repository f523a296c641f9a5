#pragma once

/// Distances of triangles, and of a posed tree, from a solid.

#include <pelt/solid.hpp>

#include "base/instruction_set.hpp"
#include "base/vec3.hpp"
#include "geometry/triangle_distance.hpp"
#include "pose/posed_tree.hpp"
#include "query/scratch.hpp"
#include "solid/prepared_region.hpp"

#include <cstdint>
#include <limits>

namespace pelt::detail {

/// A point of a triangle, a point of a solid, and their distance.
struct SolidPoints {
  double distance = std::numeric_limits<double>::infinity();
  Barycentrics at = {};
  Vec3d on_solid;
};

/// Definition of the distance of a triangle from a solid. Precondition: they do not touch.
SolidPoints closest_points(const TriangleCorners& triangle, const Solid& solid);

/// Returns a point of the triangle inside the solid, in the precision of double. Precondition: they
/// touch.
Barycentrics common_point(const TriangleCorners& triangle, const Solid& solid);

/// Error of the distance of a triangle, in units of kDistanceError: the largest coordinate of the
/// solid, times 2^24 for a box with rounded corners.
double extent_of(const Solid& solid);

/// A solid, with its prepared form for boxes.
struct PreparedSolid {
  explicit PreparedSolid(const Solid& s);

  const Solid& solid;
  PreparedRegion region;
  double extent;
};

/// The triangle closest to a solid.
struct SolidGap {
  std::uint32_t triangle = 0;  ///< the caller's number
  TriangleCorners corners = {};
  SolidPoints closest;
};

inline namespace PELT_INSTRUCTION_SET {

/// Finds the closest triangle as defined by `pelt::distance`, for a pose that does not touch the
/// solid. The distance is infinite if nothing is within `max_distance`.
QueryStats closest_to_solid(const PosedTree& posed, const PreparedSolid& solid, Scratch& scratch,
                            double max_distance, SolidGap& closest);

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail

#pragma once

/// Intersections of pairs of triangles.

#include "geometry/triangle_crossing.hpp"
#include "model/surface.hpp"
#include "pose/pose.hpp"

#include <span>

namespace pelt::detail {

/// A pose and its surface.
struct PosedSurface {
  Pose& pose;
  const Surface& surface;

  /// Returns the corners of a triangle, given by the caller's number. Opens the triangle's node if
  /// it is closed, and counts that in `work`.
  TriangleCorners corners(std::uint32_t triangle, QueryStats& work) const;
};

/// Returns the crossing of a contact's triangles as a `ContactTrace`, and counts the work.
ContactTrace trace_of(const Contact& contact, const PosedSurface& a, const PosedSurface& b,
                      Crossing& crossing, QueryStats& work);

}  // namespace pelt::detail

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

  /// The corners of a triangle by the caller's number. Opens the triangle's node if it is not open,
  /// which is counted in `work`.
  TriangleCorners corners(std::uint32_t triangle, QueryStats& work) const;
};

/// The crossing of a contact's triangles, as `ContactTrace` has it; counted in `work`.
ContactTrace trace_of(const Contact& contact, const PosedSurface& a, const PosedSurface& b,
                      Crossing& crossing, QueryStats& work);

}  // namespace pelt::detail

#pragma once

/// What each pair of triangles has in common.

#include "contact/surface.hpp"
#include "geometry/triangle_crossing.hpp"
#include "pose/pose.hpp"

#include <span>

namespace pelt::detail {

/// A pose and its surface.
struct PosedSurface {
  Pose& pose;
  const Surface& surface;

  /// Of a triangle by the caller's number; its node is opened if it was not.
  TriangleCorners corners(std::uint32_t triangle) const;
};

/// The crossing of a contact's triangles, as `ContactTrace` has it.
ContactTrace trace_of(const Contact& contact, const PosedSurface& a, const PosedSurface& b,
                      Crossing& crossing);

}  // namespace pelt::detail

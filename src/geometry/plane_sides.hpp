#pragma once

#include "exact/predicates.hpp"
#include "geometry/triangle_pair.hpp"

#include <array>

namespace pelt::detail {

/// The side of another triangle's plane for each corner of a triangle: 1 in front, -1 behind. If
/// the other triangle has collapsed, all corners are on its plane.
using PlaneSides = std::array<int, 3>;

inline PlaneSides sides_of(const TriangleCorners& corners, const TriangleCorners& plane) {
  const OrientedPlane oriented(plane[0], plane[1], plane[2]);
  return {oriented.side(corners[0]), oriented.side(corners[1]), oriented.side(corners[2])};
}

inline bool all_on_plane(const PlaneSides& s) { return s[0] == 0 && s[1] == 0 && s[2] == 0; }

}  // namespace pelt::detail

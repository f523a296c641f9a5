#pragma once

#include "geometry/triangle_pair.hpp"
#include "volume/perturbed_points.hpp"

#include <pelt/mesh.hpp>

namespace pelt::detail {

inline NumberedTriangle numbered(const TriangleCorners& corners, const Triangle& numbers) {
  return {{{corners[0], numbers[0]}, {corners[1], numbers[1]}, {corners[2], numbers[2]}}};
}

}  // namespace pelt::detail

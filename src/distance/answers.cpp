#include "distance/answers.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace pelt::detail {

SurfacePoint surface_point(std::uint32_t triangle, const TriangleCorners& corners,
                           const Barycentrics& at) {
  SurfacePoint point;
  point.triangle = triangle;
  for (std::size_t i = 0; i < 3; ++i) point.barycentrics[i] = static_cast<float>(at[i]);
  point.position = to_float(point_at(corners, at));
  return point;
}

Distance distance_apart(const TriangleGap& gap, const DistanceOptions& options) {
  Distance nearest;
  nearest.distance = std::sqrt(gap.nearest.squared_distance);
  nearest.lower_bound =
      nearest.found() ? std::max(0.0, nearest.distance - options.tolerance) : options.max_distance;
  nearest.a = surface_point(gap.triangle_a, gap.corners_a, gap.nearest.a);
  nearest.b = surface_point(gap.triangle_b, gap.corners_b, gap.nearest.b);
  nearest.places = gap.places;
  return nearest;
}

}  // namespace pelt::detail

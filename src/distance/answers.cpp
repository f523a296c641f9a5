#include "distance/answers.hpp"
#include "query/answers.hpp"

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

Distance distance_touching(const Contact& contact, const TriangleCorners& corners_a,
                           const TriangleCorners& corners_b) {
  const ClosestPoints common = common_point(corners_a, corners_b);
  Distance closest;
  closest.distance = 0;
  closest.a = surface_point(contact.triangle_a, corners_a, common.a);
  closest.b = surface_point(contact.triangle_b, corners_b, common.b);
  return closest;
}

Distance distance_apart(const TriangleGap& gap, const DistanceOptions& options) {
  Distance closest;
  closest.distance = std::sqrt(gap.closest.squared_distance);
  closest.lower_bound =
      closest ? std::max(0.0, closest.distance - options.tolerance) : options.max_distance;
  closest.a = surface_point(gap.triangle_a, gap.corners_a, gap.closest.a);
  closest.b = surface_point(gap.triangle_b, gap.corners_b, gap.closest.b);
  closest.location = Access::location(gap.slots);
  return closest;
}

}  // namespace pelt::detail

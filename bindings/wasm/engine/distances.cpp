/// Distances of surfaces from points and from each other.

#include <pelt/distance.hpp>

#include "bindings/wasm/engine/answer.hpp"
#include "bindings/wasm/engine/handles.hpp"
#include "bindings/wasm/engine/surface_points.hpp"

namespace pelt::wasm {

/// The answer is the point, the stats and the distance.
PELT_EXPORT std::uint32_t pelt_closest_point(PoseHandle* handle, float x, float y, float z,
                                             double most) {
  ClosestPoint closest;
  answer_stats(closest_point(handle->pose, {x, y, z}, scratch(), closest, {.max_distance = most}));
  answer().distance = closest.distance;
  answer_points({{closest.point, *handle}});
  return closest ? 1 : 0;
}

/// The answer is the two points, the stats, the distance and a lower bound of the distance.
PELT_EXPORT std::uint32_t pelt_distance(PoseHandle* a, PoseHandle* b, double most,
                                        double tolerance) {
  Distance closest;
  DistanceOptions options;
  options.max_distance = most;
  options.tolerance = tolerance;
  answer_stats(distance(a->pose, b->pose, scratch(), closest, options));
  answer().distance = closest.distance;
  answer().lower_bound = closest.lower_bound;
  answer_points({{closest.a, *a}, {closest.b, *b}});
  return closest ? 1 : 0;
}

}  // namespace pelt::wasm

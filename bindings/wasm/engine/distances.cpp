/// Distances of surfaces from points and from each other, inside and outside of closed surfaces.

#include <pelt/distance.hpp>
#include <pelt/inside.hpp>

#include "bindings/wasm/engine/export.hpp"
#include "bindings/wasm/engine/handles.hpp"

#include <initializer_list>

namespace pelt::wasm {
namespace {

struct PointOfPose {
  const SurfacePoint& point;
  const PoseHandle& pose;
};

/// Answers with these points, seven numbers each: triangle, position, weights of the triangle's
/// vertices.
void answer_points(std::initializer_list<PointOfPose> points) {
  static std::vector<double> rows;
  rows.clear();
  for (const auto& [point, pose] : points) {
    const auto& [x, y, z] = point.position;
    const auto& [u, v, w] = point.barycentrics;
    const std::uint32_t triangle = pose.body.first_triangle + point.triangle;
    rows.insert(rows.end(), {static_cast<double>(triangle), x, y, z, u, v, w});
  }
  answer_arrays(rows);
}

}  // namespace

/// The answer is the point and the distance.
bool closest_point(PoseHandle& handle, float x, float y, float z, double most) {
  ClosestPoint closest;
  answer_stats(closest_point(handle.pose, {x, y, z}, scratch(), closest, {.max_distance = most}));
  answer().distance = closest.distance;
  answer_points({{closest.point, handle}});
  return static_cast<bool>(closest);
}
PELT_EXPORT(closest_point)

/// The answer is the two points, the distance and a lower bound of the distance.
bool distance(PoseHandle& a, PoseHandle& b, double most, double tolerance) {
  Distance closest;
  DistanceOptions options;
  options.max_distance = most;
  options.tolerance = tolerance;
  answer_stats(distance(a.pose, b.pose, scratch(), closest, options));
  answer().distance = closest.distance;
  answer().lower_bound = closest.lower_bound;
  answer_points({{closest.a, a}, {closest.b, b}});
  return static_cast<bool>(closest);
}
PELT_EXPORT(distance)

bool is_closed(const PoseHandle& handle) { return handle.pose.model().surface().is_closed(); }
PELT_EXPORT(is_closed)

/// Precondition: the surface is closed.
PointSide side_of(PoseHandle& handle, float x, float y, float z) {
  PointSide side = PointSide::outside;
  answer_stats(side_of(handle.pose, {x, y, z}, scratch(), side));
  return side;
}
PELT_EXPORT(side_of)

/// The answer is the closest point of b's surface, the vertex, its position and its depth.
/// Precondition: the surface of b is closed.
bool deepest_vertex(PoseHandle& a, PoseHandle& b) {
  Penetration deepest;
  answer_stats(deepest_vertex(a.pose, b.pose, scratch(), deepest));
  answer().vertex = deepest.vertex;
  answer().position = numbers_of(deepest.position);
  answer().depth = deepest.depth;
  answer_points({{deepest.closest, b}});
  return static_cast<bool>(deepest);
}
PELT_EXPORT(deepest_vertex)

Containment containment(PoseHandle& a, PoseHandle& b) {
  Containment found = Containment::none;
  answer_stats(containment(a.pose, b.pose, scratch(), found));
  return found;
}
PELT_EXPORT(containment)

}  // namespace pelt::wasm

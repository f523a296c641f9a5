/// A point is inside where the surface winds around it: where a ray from it leaves the surface more
/// often than it enters, or less often. Rays tell exactly through which triangles they go and from
/// which side; one that goes through an edge or a corner, or runs in a triangle, names triangles
/// twice or not at all, so another one is asked.

#include <pelt/inside.hpp>

#include "base/assert.hpp"
#include "base/wide_code.hpp"
#include "inside/directions.hpp"
#include "pose/pose.hpp"
#include "query/scratch.hpp"

#include <algorithm>

namespace pelt {
namespace {

using detail::PosedTree;
using detail::Stack;

bool is_far(const detail::RootBox& root, const Vec3& p) {
  return p.x < root.low[0] || root.high[0] < p.x || p.y < root.low[1] || root.high[1] < p.y ||
         p.z < root.low[2] || root.high[2] < p.z;
}

/// Rays that do not leave the point meet the triangles on which it lies, but for those that they
/// are parallel to. No triangle is parallel to three directions that are not in one plane.
bool is_on_surface(const PosedTree& posed, const Vec3& point) {
  std::array<Ray, 3> rays;
  std::array<bool, 3> hit;
  for (std::size_t i = 0; i < 3; ++i) rays[i] = {point, detail::kAxes[i], 0, 0};
  detail::wide_code().any_hits(posed, rays, Facing::both, hit);
  return hit[0] || hit[1] || hit[2];
}

bool goes_through_edge(const RayHit& hit) {
  return std::find(hit.weights.begin(), hit.weights.end(), 0.0f) != hit.weights.end();
}

/// How often the ray goes through the surface from one side; -1 where it goes through an edge.
int crossings(const PosedTree& posed, const Ray& ray, Facing facing, Stack<RayHit>& hits) {
  hits.clear();
  detail::wide_code().all_hits(posed, ray, facing, hits);
  if (std::any_of(hits.begin(), hits.end(), goes_through_edge)) return -1;
  return static_cast<int>(hits.size());
}

}  // namespace

PointSide side_of(Pose& pose, const Surface& surface, const Vec3& point, Scratch& scratch) {
  PELT_ASSERT(surface.is_closed());
  PELT_ASSERT(&pose.model().detail() == &surface.model().detail());
  const PosedTree posed = pose.detail().posed_tree();
  QueryStats uncounted;
  if (is_far(detail::wide_code().root_box(posed, uncounted), point)) return PointSide::outside;
  if (is_on_surface(posed, point)) return PointSide::on;
  Stack<RayHit>& hits = scratch.detail().ray_hits;
  for (detail::Directions directions;; directions.next()) {
    const Ray ray = {point, directions.current()};
    const int left = crossings(posed, ray, Facing::back, hits);
    if (left < 0) continue;
    const int entered = crossings(posed, ray, Facing::front, hits);
    if (entered >= 0) return left == entered ? PointSide::outside : PointSide::inside;
  }
}

}  // namespace pelt

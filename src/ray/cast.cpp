#include <pelt/ray.hpp>

#include "base/require.hpp"
#include "pose/pose.hpp"
#include "query/scratch.hpp"
#include "query/valid_numbers.hpp"
#include "ray/ray_descent.hpp"

#include <algorithm>
#include <cstddef>

namespace pelt {
namespace {

bool comes_before(const RayHit& a, const RayHit& b) {
  return a.t < b.t || (a.t == b.t && a.triangle < b.triangle);
}

}  // namespace

Ray segment(const Vec3& from, const Vec3& to) {
  return {from, {to.x - from.x, to.y - from.y, to.z - from.z}, 0, 1};
}

QueryStats cast(Pose& pose, std::span<const Ray> rays, std::span<RayHit> hits,
                const CastOptions& options) {
  detail::require(hits.size() == rays.size(), "cast: give one hit for each ray");
  detail::require(detail::are_valid(rays), "cast: a ray has a NaN or infinite coordinate");
  return detail::first_hits(pose.detail().posed_tree(), rays, options.facing, hits);
}

QueryStats cast(Pose& pose, const Ray& ray, RayHit& result, const CastOptions& options) {
  return cast(pose, std::span(&ray, 1), std::span(&result, 1), options);
}

QueryStats cast_any(Pose& pose, std::span<const Ray> rays, std::span<bool> hit,
                    const CastOptions& options) {
  detail::require(hit.size() == rays.size(), "cast_any: give one answer for each ray");
  detail::require(detail::are_valid(rays), "cast_any: a ray has a NaN or infinite coordinate");
  return detail::any_hits(pose.detail().posed_tree(), rays, options.facing, hit);
}

QueryStats cast_all(Pose& pose, const Ray& ray, Scratch& scratch, std::vector<RayHit>& hits,
                    const CastOptions& options) {
  detail::require(detail::is_valid(ray), "cast_all: the ray has a NaN or infinite coordinate");
  detail::Stack<RayHit>& found = scratch.detail().ray_hits;
  found.clear();
  const QueryStats work = detail::all_hits(pose.detail().posed_tree(), ray, options.facing, found);
  std::sort(found.begin(), found.end(), comes_before);
  hits.insert(hits.end(), found.begin(), found.end());
  return work;
}

}  // namespace pelt

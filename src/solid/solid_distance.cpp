#include <pelt/solid.hpp>

#include "base/require.hpp"
#include "distance/answers.hpp"
#include "pose/pose.hpp"
#include "query/find_triangle.hpp"
#include "query/scratch.hpp"
#include "solid/region_descent.hpp"
#include "solid/solid_search.hpp"

#include <algorithm>

namespace pelt {
namespace detail {
namespace {

/// Writes the touching triangles to `scratch.touching`.
QueryStats find_touching(const PosedTree& posed, const PreparedRegion& region, Scratch& scratch) {
  return (region.is_capsule
              ? descend_in_capsule(posed, region.capsule, scratch, RegionGoal::triangles)
              : descend_in_faces(posed, region.faces, scratch, RegionGoal::triangles))
      .work;
}

SolidDistance touching(const PosedTree& posed, const Solid& solid, std::uint32_t triangle,
                       QueryStats& work) {
  make_table(posed);  // bodies wholly inside have not been opened
  const TriangleCorners corners = find_triangle(posed, triangle, work).corners;
  SolidDistance closest;
  closest.distance = 0;
  closest.surface = surface_point(triangle, corners, common_point(corners, solid));
  closest.solid = closest.surface.position;
  return closest;
}

}  // namespace

PreparedSolid::PreparedSolid(const Solid& s)
    : solid(s), region(region_of(s)), extent(extent_of(s)) {}

}  // namespace detail

QueryStats distance(Pose& pose, const Solid& solid, Scratch& scratch, SolidDistance& result,
                    const Limits& limits) {
  detail::require(limits.max_distance >= 0, "distance: the maximum distance is negative or NaN");
  const detail::PosedTree posed = pose.detail().posed_tree();
  const detail::PreparedSolid prepared(solid);
  QueryStats stats = detail::find_touching(posed, prepared.region, scratch.detail());
  if (detail::Stack<std::uint32_t>& found = scratch.detail().touching; !found.empty()) {
    result = detail::touching(posed, solid, *std::min_element(found.begin(), found.end()), stats);
    return stats;
  }
  detail::SolidGap gap;
  stats += detail::closest_to_solid(posed, prepared, scratch.detail(), limits.max_distance, gap);
  result.distance = gap.closest.distance;
  result.surface = detail::surface_point(gap.triangle, gap.corners, gap.closest.at);
  result.solid = detail::to_float(gap.closest.on_solid);
  return stats;
}

}  // namespace pelt

#include <pelt/height_field.hpp>

#include "base/require.hpp"
#include "distance/answers.hpp"
#include "field/field_cast.hpp"
#include "field/field_collide.hpp"
#include "field/field_distance.hpp"
#include "pose/pose.hpp"
#include "query/access.hpp"
#include "query/find_triangle.hpp"
#include "query/scratch.hpp"
#include "query/sort_contacts.hpp"
#include "query/yes_or_no.hpp"

#include <algorithm>

namespace pelt {
namespace {

using detail::PosedTree;

/// Writes the contacts to `scratch`, in no particular order.
QueryStats find_contacts(const PosedTree& posed, const HeightField& field, Scratch& scratch,
                         std::uint32_t max_contacts) {
  return detail::collide_field(posed, field.detail(), scratch.detail(), max_contacts);
}

/// Returns the lowest touching pair.
Distance touching(const PosedTree& posed, const HeightField& field, const Contact& contact,
                  QueryStats& work) {
  const detail::FoundTriangle found = detail::find_triangle(posed, contact.triangle_a, work);
  const detail::TriangleCorners other = field.triangle(contact.triangle_b);
  const detail::ClosestPoints common = detail::common_point(found.corners, other);
  Distance closest;
  closest.distance = 0;
  closest.a = detail::surface_point(contact.triangle_a, found.corners, common.a);
  closest.b = detail::surface_point(contact.triangle_b, other, common.b);
  return closest;
}

}  // namespace

QueryStats collide(Pose& pose, const HeightField& field, Scratch& scratch,
                   std::vector<Contact>& contacts, const CollideOptions& options) {
  const QueryStats stats =
      find_contacts(pose.detail().posed_tree(), field, scratch, options.max_contacts);
  detail::append_sorted(scratch.detail(), contacts);
  return stats;
}

YesNo intersects(Pose& pose, const HeightField& field, Scratch& scratch) {
  const QueryStats stats = find_contacts(pose.detail().posed_tree(), field, scratch, 1);
  return detail::yes_or_no(!scratch.detail().found.empty(), stats);
}

QueryStats distance(Pose& pose, const HeightField& field, Scratch& scratch, Distance& result,
                    const DistanceOptions& options) {
  detail::require(options.max_distance >= 0 && options.tolerance >= 0,
                  "distance: the maximum distance or the tolerance is negative or NaN");
  const PosedTree posed = pose.detail().posed_tree();
  const std::uint32_t wanted = options.tolerance > 0 ? 1 : CollideOptions().max_contacts;
  QueryStats stats = find_contacts(posed, field, scratch, wanted);
  stats.cut_short = false;
  if (detail::Stack<Contact>& found = scratch.detail().found; !found.empty()) {
    result = touching(posed, field, *std::min_element(found.begin(), found.end()), stats);
    return stats;
  }
  const detail::ClusterSlots hint =
      options.hint ? detail::Access::numbers(options.hint->location) : detail::ClusterSlots{};
  const detail::SearchLimits limits = {options.max_distance, options.tolerance,
                                       options.hint ? &hint : nullptr};
  detail::TriangleGap gap;
  stats += detail::closest_field_triangle(posed, field.detail(), scratch.detail(), limits, gap);
  result = detail::distance_apart(gap, options);
  return stats;
}

QueryStats cast(const HeightField& field, std::span<const Ray> rays, std::span<RayHit> hits,
                const CastOptions& options) {
  detail::require(hits.size() == rays.size(), "cast: give one hit for each ray");
  QueryStats stats;
  for (std::size_t i = 0; i < rays.size(); ++i)
    hits[i] = detail::cast_at_field(field.detail(), rays[i], options.facing, stats);
  return stats;
}

QueryStats cast(const HeightField& field, const Ray& ray, RayHit& result,
                const CastOptions& options) {
  return cast(field, std::span(&ray, 1), std::span(&result, 1), options);
}

}  // namespace pelt

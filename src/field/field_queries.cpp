#include <pelt/height_field.hpp>

#include "base/assert.hpp"
#include "distance/answers.hpp"
#include "field/field_cast.hpp"
#include "field/field_collide.hpp"
#include "field/field_distance.hpp"
#include "pose/pose.hpp"
#include "query/find_triangle.hpp"
#include "query/scratch.hpp"
#include "query/sort_contacts.hpp"

#include <algorithm>

namespace pelt {
namespace {

using detail::PosedTree;

/// Writes the contacts to `scratch`, in no particular order.
QueryStats find_contacts(const PosedTree& posed, const HeightField& field, Scratch& scratch,
                         std::uint32_t max_contacts) {
  return detail::collide_field(posed, field.detail(), scratch.detail(), max_contacts);
}

/// The lowest pair of those that touch.
Distance touching(const PosedTree& posed, const HeightField& field, const Contact& contact,
                  QueryStats& work) {
  const detail::FoundTriangle found = detail::find_triangle(posed, contact.triangle_a, work);
  const detail::TriangleCorners other = field.triangle(contact.triangle_b);
  const detail::NearestPoints common = detail::common_point(found.corners, other);
  Distance nearest;
  nearest.distance = 0;
  nearest.a = detail::surface_point(contact.triangle_a, found.corners, common.a);
  nearest.b = detail::surface_point(contact.triangle_b, other, common.b);
  return nearest;
}

}  // namespace

QueryStats collide(Pose& pose, const HeightField& field, Scratch& scratch,
                   std::vector<Contact>& contacts, const CollideOptions& options) {
  const QueryStats stats =
      find_contacts(pose.detail().posed_tree(), field, scratch, options.max_contacts);
  detail::append_sorted(scratch.detail(), contacts);
  return stats;
}

bool intersects(Pose& pose, const HeightField& field, Scratch& scratch) {
  find_contacts(pose.detail().posed_tree(), field, scratch, 1);
  return !scratch.detail().found.empty();
}

QueryStats distance(Pose& pose, const HeightField& field, Scratch& scratch, Distance& nearest,
                    const DistanceOptions& options) {
  PELT_ASSERT(options.max_distance >= 0 && options.tolerance >= 0);
  const PosedTree posed = pose.detail().posed_tree();
  const std::uint32_t wanted = options.tolerance > 0 ? 1 : CollideOptions().max_contacts;
  QueryStats stats = find_contacts(posed, field, scratch, wanted);
  stats.cut_short = false;
  if (detail::Stack<Contact>& found = scratch.detail().found; !found.empty()) {
    nearest = touching(posed, field, *std::min_element(found.begin(), found.end()), stats);
    return stats;
  }
  const detail::Places hint = options.hint ? options.hint->places : detail::Places{};
  const detail::SearchLimits limits = {options.max_distance, options.tolerance,
                                       options.hint ? &hint : nullptr};
  detail::TriangleGap gap;
  stats += detail::nearest_field_triangle(posed, field.detail(), scratch.detail(), limits, gap);
  nearest = detail::distance_apart(gap, options);
  return stats;
}

QueryStats cast(const HeightField& field, std::span<const Ray> rays, std::span<RayHit> hits,
                const CastOptions& options) {
  PELT_ASSERT(hits.size() == rays.size());
  QueryStats stats;
  for (std::size_t i = 0; i < rays.size(); ++i)
    hits[i] = detail::cast_at_field(field.detail(), rays[i], options.facing, stats);
  return stats;
}

RayHit cast(const HeightField& field, const Ray& ray, const CastOptions& options) {
  RayHit hit;
  cast(field, std::span(&ray, 1), std::span(&hit, 1), options);
  return hit;
}

}  // namespace pelt

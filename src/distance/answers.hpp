#pragma once

/// Answers to queries for the least distance, from what a search has found.

#include <pelt/distance.hpp>

#include "base/assert.hpp"
#include "distance/distance_search.hpp"
#include "query/answers.hpp"
#include "query/scratch.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace pelt::detail {

inline SurfacePoint surface_point(std::uint32_t triangle, const TriangleCorners& corners,
                                  const Barycentrics& at) {
  SurfacePoint point;
  point.triangle = triangle;
  for (std::size_t i = 0; i < 3; ++i) point.barycentrics[i] = static_cast<float>(at[i]);
  point.position = to_float(point_at(corners, at));
  return point;
}

/// Returns the answer for two triangles that touch, without a location.
inline Distance distance_touching(const Contact& contact, const TriangleCorners& corners_a,
                                  const TriangleCorners& corners_b) {
  const ClosestPoints common = common_point(corners_a, corners_b);
  Distance closest;
  closest.distance = 0;
  closest.a = surface_point(contact.triangle_a, corners_a, common.a);
  closest.b = surface_point(contact.triangle_b, corners_b, common.b);
  return closest;
}

/// Returns the answer for operands that do not touch, from a search within the options' limits.
inline Distance distance_apart(const TriangleGap& gap, const DistanceOptions& options) {
  Distance closest;
  closest.distance = std::sqrt(gap.closest.squared_distance);
  closest.lower_bound =
      closest ? std::max(0.0, closest.distance - options.tolerance) : options.max_distance;
  closest.a = surface_point(gap.triangle_a, gap.corners_a, gap.closest.a);
  closest.b = surface_point(gap.triangle_b, gap.corners_b, gap.closest.b);
  closest.location = Access::location(gap.slots);
  return closest;
}

/// Computes the least distance of a pose from another pose or from a height field.
///
/// `find_touching(most, max_work)`: writes up to `most` touching pairs to `scratch.found`; returns
///   its work, with `cut_short` if `max_work` ended it.
/// `describe(contact, work)`: returns the answer for a touching pair; adds to `work`.
/// `find_closest(limits, gap)`: finds the closest triangles of operands that do not touch; returns
///   its work.
template <typename FindTouching, typename Describe, typename FindClosest>
QueryStats least_distance(Scratch& scratch, const DistanceOptions& options, Distance& result,
                          const FindTouching& find_touching, const Describe& describe,
                          const FindClosest& find_closest) {
  require(options.max_distance >= 0 && options.tolerance >= 0,
          "distance: the maximum distance or the tolerance is negative or NaN");
  const bool is_limited = options.max_work != SearchLimits::kUnlimited;
  QueryStats stats = find_touching(options.tolerance > 0 ? 1 : Limits().max_contacts,
                                   is_limited ? options.max_work / 2 : options.max_work);
  const bool is_unsure = is_limited && stats.cut_short;  // whether they touch
  stats.cut_short = false;
  if (Stack<Contact>& found = scratch.found; !found.empty()) {
    result = describe(*std::min_element(found.begin(), found.end()), stats);
    stats.cut_short = is_unsure && options.tolerance == 0;
    return stats;
  }
  const ClusterSlots hint = options.hint ? Access::numbers(options.hint->location) : ClusterSlots{};
  TriangleGap gap;
  SearchLimits limits = {options.max_distance, options.tolerance, options.hint ? &hint : nullptr};
  if (is_limited) limits.work = options.max_work - std::min(options.max_work, work_of(stats));
  stats += find_closest(limits, gap);
  stats.cut_short = stats.cut_short || is_unsure;
  result = distance_apart(gap, options);
  result.lower_bound = is_unsure ? 0 : std::min(result.lower_bound, gap.open_distance);
  return stats;
}

}  // namespace pelt::detail

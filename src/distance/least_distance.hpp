#pragma once

#include <pelt/distance.hpp>

#include "base/require.hpp"
#include "distance/answers.hpp"
#include "distance/pair_search.hpp"
#include "query/access.hpp"
#include "query/scratch.hpp"

#include <algorithm>

namespace pelt::detail {

/// Computes the least distance of a pose from another pose or from a height field.
///
/// `find_touching(most)`: writes up to `most` touching pairs to `scratch.found`; returns its work.
/// `describe(contact, work)`: returns the answer for a touching pair; adds to `work`.
/// `find_closest(limits, gap)`: finds the closest triangles of operands that do not touch; returns
///   its work.
template <typename FindTouching, typename Describe, typename FindClosest>
QueryStats least_distance(Scratch& scratch, const DistanceOptions& options, Distance& result,
                          const FindTouching& find_touching, const Describe& describe,
                          const FindClosest& find_closest) {
  require(options.max_distance >= 0 && options.tolerance >= 0,
          "distance: the maximum distance or the tolerance is negative or NaN");
  QueryStats stats = find_touching(options.tolerance > 0 ? 1 : CollideOptions().max_contacts);
  stats.cut_short = false;
  if (Stack<Contact>& found = scratch.found; !found.empty()) {
    result = describe(*std::min_element(found.begin(), found.end()), stats);
    return stats;
  }
  const ClusterSlots hint = options.hint ? Access::numbers(options.hint->location) : ClusterSlots{};
  TriangleGap gap;
  const SearchLimits limits = {options.max_distance, options.tolerance,
                               options.hint ? &hint : nullptr};
  stats += find_closest(limits, gap);
  result = distance_apart(gap, options);
  return stats;
}

}  // namespace pelt::detail

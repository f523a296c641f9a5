#pragma once

#include "base/instruction_set.hpp"
#include "geometry/triangle_distance.hpp"
#include "pose/posed_tree.hpp"
#include "query/scratch.hpp"

#include <array>
#include <cstdint>
#include <limits>

namespace pelt::detail {

/// Two clusters, each by its node and slot.
using ClusterSlots = std::array<std::uint32_t, 4>;

/// Two triangles that do not touch, and their distance.
struct TriangleGap {
  std::uint32_t triangle_a = 0, triangle_b = 0;  ///< the caller's numbers
  TriangleCorners corners_a = {}, corners_b = {};
  ClosestPoints closest = {std::numeric_limits<double>::infinity(), {}, {}};
  ClusterSlots slots = {};  ///< the clusters of the triangles

  /// Lower bound of the distances of all pairs that a search did not compare because its work was
  /// limited; infinite if it was not cut short.
  double open_distance = std::numeric_limits<double>::infinity();
};

/// Limits of `closest_triangles`.
struct SearchLimits {
  double max_distance, tolerance;
  const ClusterSlots* begin;  ///< clusters to start with; null, or any clusters

  static constexpr std::uint64_t kUnlimited = std::numeric_limits<std::uint64_t>::max();
  std::uint64_t work = kUnlimited;  ///< in units of work_of
};

inline namespace PELT_INSTRUCTION_SET {

/// Finds the least distance of two poses that do not touch, as defined by `pelt::distance`;
/// infinite if nothing is within the maximum.
QueryStats closest_triangles(const PosedTree& a, const PosedTree& b, Scratch& scratch,
                             const SearchLimits& limits, TriangleGap& closest);

/// Appends all pairs at most `tolerance` apart to the touching pairs in `scratch.found`, in no
/// particular order. Stops at `max_pairs` in total.
QueryStats triangles_within(const PosedTree& a, const PosedTree& b, Scratch& scratch,
                            double tolerance, std::uint32_t max_pairs);

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail

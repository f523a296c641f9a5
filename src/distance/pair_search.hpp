#pragma once

#include "base/target.hpp"
#include "geometry/triangle_distance.hpp"
#include "pose/posed_tree.hpp"
#include "query/scratch.hpp"

#include <array>
#include <cstdint>
#include <limits>

namespace pelt::detail {

/// Two clusters, each by its node and slot.
using Places = std::array<std::uint32_t, 4>;

/// Two triangles that do not touch, and their distance.
struct TriangleGap {
  std::uint32_t triangle_a = 0, triangle_b = 0;  ///< the caller's numbers
  TriangleCorners corners_a = {}, corners_b = {};
  NearestPoints nearest = {std::numeric_limits<double>::infinity(), {}, {}};
  Places places = {};  ///< the clusters of the triangles
};

/// Limits of `nearest_triangles`.
struct SearchLimits {
  double max_distance, tolerance;
  const Places* begin;  ///< clusters to start with; null, or any clusters
};

inline namespace PELT_TARGET {

/// Finds the least distance of two poses that do not touch, as defined by `pelt::distance`;
/// infinite if nothing is within the maximum.
QueryStats nearest_triangles(const PosedTree& a, const PosedTree& b, Scratch& scratch,
                             const SearchLimits& limits, TriangleGap& nearest);

/// Appends all pairs at most `tolerance` apart to the touching pairs in `scratch.found`, in no
/// particular order. Stops at `max_pairs` in total.
QueryStats triangles_within(const PosedTree& a, const PosedTree& b, Scratch& scratch,
                            double tolerance, std::uint32_t max_pairs);

}  // namespace PELT_TARGET
}  // namespace pelt::detail

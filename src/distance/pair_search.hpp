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

/// Two triangles that do not touch, and how far they are apart.
struct TriangleGap {
  std::uint32_t triangle_a = 0, triangle_b = 0;  ///< the caller's numbers
  TriangleCorners corners_a = {}, corners_b = {};
  NearestPoints nearest = {std::numeric_limits<double>::infinity(), {}, {}};
  Places places = {};  ///< the clusters that they are in
};

/// What `nearest_triangles` need not do.
struct SearchLimits {
  double max_distance, tolerance;
  const Places* begin;  ///< clusters to begin with; null, or anything
};

inline namespace PELT_TARGET {

/// The least distance of two poses that touch nowhere, as `pelt::distance` says; infinite if
/// nothing is within the maximum.
QueryStats nearest_triangles(const PosedTree& a, const PosedTree& b, Scratch& scratch,
                             const SearchLimits& limits, TriangleGap& nearest);

/// Appends to the pairs that touch, which are in `scratch.found`, all others that are at most
/// `tolerance` apart, in no particular order; stops once there are `max_pairs` of both.
QueryStats triangles_within(const PosedTree& a, const PosedTree& b, Scratch& scratch,
                            double tolerance, std::uint32_t max_pairs);

}  // namespace PELT_TARGET
}  // namespace pelt::detail

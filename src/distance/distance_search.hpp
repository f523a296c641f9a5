#pragma once

/// Searches of two poses, or of a pose and a point, for the least distance.

#include "base/instruction_set.hpp"
#include "geometry/triangle_distance.hpp"
#include "pose/posed_tree.hpp"
#include "query/scratch.hpp"

#include <array>
#include <cmath>
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

/// The triangle that is closest to a point.
struct PointGap {
  std::uint32_t triangle = 0;  ///< the caller's number
  TriangleCorners corners = {};
  ClosestOnTriangle closest = {std::numeric_limits<double>::infinity(), {}};
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

/// Finds the triangle as defined by `pelt::closest_point`. The distance is infinite if nothing is
/// within `max_distance`.
QueryStats closest_to_point(const PosedTree& posed, const Vec3& point, Scratch& scratch,
                            double max_distance, PointGap& closest);

/// Stores the pair with the least distance; of equally near pairs, the one with the lowest numbers.
class LeastGap {
 public:
  LeastGap(const SearchLimits& limits, TriangleGap& best) : limits_(limits), best_(best) {}

  double reach() const {
    if (!is_found_) return limits_.max_distance;
    const double reach = std::sqrt(best_.closest.squared_distance) - limits_.tolerance;
    return reach > 0 ? reach : 0;
  }

  bool keeps_best() const { return true; }
  bool is_done() const { return false; }

  bool wants(const TriangleGap& gap) const {
    return is_found_ ? is_better(gap)
                     : std::sqrt(gap.closest.squared_distance) <= limits_.max_distance;
  }

  void take(const TriangleGap& gap) {
    best_ = gap;
    is_found_ = true;
  }

 private:
  bool is_better(const TriangleGap& gap) const {
    const double squared = gap.closest.squared_distance, best = best_.closest.squared_distance;
    if (squared != best) return squared < best;
    if (gap.triangle_a != best_.triangle_a) return gap.triangle_a < best_.triangle_a;
    return gap.triangle_b < best_.triangle_b;
  }

  const SearchLimits& limits_;
  TriangleGap& best_;
  bool is_found_ = false;
};

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail

#pragma once

#include "base/target.hpp"
#include "geometry/triangle_distance.hpp"
#include "pose/posed_tree.hpp"
#include "query/scratch.hpp"

#include <cstdint>
#include <limits>

namespace pelt::detail {

/// The triangle that is nearest to a point.
struct PointGap {
  std::uint32_t triangle = 0;  ///< the caller's number
  TriangleCorners corners = {};
  NearestOnTriangle nearest = {std::numeric_limits<double>::infinity(), {}};
};

inline namespace PELT_TARGET {

/// Finds the triangle as defined by `pelt::closest_point`. The distance is infinite if nothing is
/// within `max_distance`.
QueryStats nearest_to_point(const PosedTree& posed, const Vec3& point, Scratch& scratch,
                            double max_distance, PointGap& nearest);

}  // namespace PELT_TARGET
}  // namespace pelt::detail

#pragma once

#include "base/instruction_set.hpp"
#include "geometry/triangle_distance.hpp"
#include "pose/posed_tree.hpp"
#include "query/scratch.hpp"

#include <cstdint>
#include <limits>

namespace pelt::detail {

/// The triangle that is closest to a point.
struct PointGap {
  std::uint32_t triangle = 0;  ///< the caller's number
  TriangleCorners corners = {};
  ClosestOnTriangle closest = {std::numeric_limits<double>::infinity(), {}};
};

inline namespace PELT_INSTRUCTION_SET {

/// Finds the triangle as defined by `pelt::closest_point`. The distance is infinite if nothing is
/// within `max_distance`.
QueryStats closest_to_point(const PosedTree& posed, const Vec3& point, Scratch& scratch,
                            double max_distance, PointGap& closest);

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail

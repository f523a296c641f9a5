#pragma once

#include "base/instruction_set.hpp"
#include "pose/posed_tree.hpp"
#include "query/scratch.hpp"
#include "solid/prepared_region.hpp"
#include "solid/solid_points.hpp"

#include <cstdint>

namespace pelt::detail {

/// A solid, with its prepared form for boxes.
struct PreparedSolid {
  explicit PreparedSolid(const Solid& s);

  const Solid& solid;
  PreparedRegion region;
  double extent;
};

/// The triangle closest to a solid.
struct SolidGap {
  std::uint32_t triangle = 0;  ///< the caller's number
  TriangleCorners corners = {};
  SolidPoints closest;
};

inline namespace PELT_INSTRUCTION_SET {

/// Finds the closest triangle as defined by `pelt::distance`, for a pose that does not touch the
/// solid. The distance is infinite if nothing is within `max_distance`.
QueryStats closest_to_solid(const PosedTree& posed, const PreparedSolid& solid, Scratch& scratch,
                            double max_distance, SolidGap& closest);

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail

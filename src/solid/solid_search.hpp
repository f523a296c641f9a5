#pragma once

#include "base/target.hpp"
#include "pose/posed_tree.hpp"
#include "query/scratch.hpp"
#include "region/prepared_region.hpp"
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

/// The triangle nearest to a solid.
struct SolidGap {
  std::uint32_t triangle = 0;  ///< the caller's number
  TriangleCorners corners = {};
  SolidPoints nearest;
};

inline namespace PELT_TARGET {

/// Finds the nearest triangle as defined by `pelt::distance`, for a pose that does not touch the
/// solid. The distance is infinite if nothing is within `max_distance`.
QueryStats nearest_to_solid(const PosedTree& posed, const PreparedSolid& solid, Scratch& scratch,
                            double max_distance, SolidGap& nearest);

}  // namespace PELT_TARGET
}  // namespace pelt::detail

#pragma once

#include "base/target.hpp"
#include "pose/posed_tree.hpp"
#include "query/scratch.hpp"
#include "region/prepared_region.hpp"
#include "solid/solid_points.hpp"

#include <cstdint>

namespace pelt::detail {

/// A solid with the form of it that boxes are compared with.
struct PreparedSolid {
  explicit PreparedSolid(const Solid& s);

  const Solid& solid;
  PreparedRegion region;
  double extent;
};

/// The triangle that is nearest to a solid.
struct SolidGap {
  std::uint32_t triangle = 0;  ///< the caller's number
  TriangleCorners corners = {};
  SolidPoints nearest;
};

inline namespace PELT_TARGET {

/// Finds it as `pelt::distance` says, of a pose that touches the solid nowhere; the distance is
/// infinite if nothing is within `max_distance`.
QueryStats nearest_to_solid(const PosedTree& posed, const PreparedSolid& solid, Scratch& scratch,
                            double max_distance, SolidGap& nearest);

}  // namespace PELT_TARGET
}  // namespace pelt::detail

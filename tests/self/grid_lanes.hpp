#pragma once

#include "base/arena.hpp"
#include "pose/posed_tree.hpp"
#include "support/compiled.hpp"

#include <cstdint>

namespace pelt::test {

/// The boxes of a cluster, exactly and on the grid.
struct GridBoxesOfCluster {
  float exact_low[3][16], exact_high[3][16];
  std::int16_t low[3][16], high[3][16], all_low[3], all_high[3];
  unsigned triangles;
  unsigned overlapping[16];  ///< the boxes of another cluster that overlap each, one bit per box
};

using GridLanes = GridBoxesOfCluster(const detail::PosedTree& posed,
                                     const std::uint32_t* cluster_nodes, std::uint32_t cluster,
                                     std::uint32_t other);

PELT_DECLARE_COMPILED(GridLanes, grid_boxes)

}  // namespace pelt::test

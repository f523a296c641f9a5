#pragma once

#include "base/arena.hpp"
#include "model/tree.hpp"

#include <cstddef>
#include <cstdint>

namespace pelt::detail {

/// Boxes of the triangles of a cluster on a grid (self/grid_boxes.hpp), and the box of all. Lanes
/// beyond the last triangle repeat its box.
struct alignas(64) ClusterGridBoxes {
  std::int16_t low[3][kMaxClusterTriangles], high[3][kMaxClusterTriangles];
  std::int16_t all_low[3], all_high[3];
  std::uint16_t triangles;  ///< one bit per triangle
};

/// Memory for the boxes of all clusters, and for whether they are known.
inline std::size_t grid_box_bytes(std::size_t cluster_count) {
  return Arena::size_of_piece(cluster_count * sizeof(ClusterGridBoxes)) +
         Arena::size_of_piece(cluster_count);
}

}  // namespace pelt::detail

#pragma once

/// Boxes of triangles in whole steps of a grid that covers the box of a pose in 2^16 steps along
/// each axis. Rounding to the grid is monotone: it takes x <= y to g(x) <= g(y). Boxes that overlap
/// therefore also overlap on the grid. The opposite is not true of boxes that are less than a step
/// apart; the test of their triangles decides. An operation on sixteen boxes of integers costs as
/// much as on eight boxes of floats.

#include "base/arena.hpp"
#include "base/short16.hpp"
#include "model/tree.hpp"
#include "pose/posed_tree.hpp"

#include <cstddef>
#include <cstdint>

namespace pelt::detail {

/// Boxes of the triangles of a cluster on a grid, and the box of all. Lanes
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

inline namespace PELT_INSTRUCTION_SET {

/// Sixteen boxes, one per lane.
struct Boxes16 {
  Short16 low[3], high[3];
};

[[gnu::always_inline]] inline Boxes16 load_boxes(const ClusterGridBoxes& boxes) {
  return {{load16(boxes.low[0]), load16(boxes.low[1]), load16(boxes.low[2])},
          {load16(boxes.high[0]), load16(boxes.high[1]), load16(boxes.high[2])}};
}

/// The box of one triangle in all lanes.
[[gnu::always_inline]] inline Boxes16 repeat_box(const ClusterGridBoxes& boxes, unsigned triangle) {
  const auto &low = boxes.low, &high = boxes.high;
  return {{Short16(low[0][triangle]), Short16(low[1][triangle]), Short16(low[2][triangle])},
          {Short16(high[0][triangle]), Short16(high[1][triangle]), Short16(high[2][triangle])}};
}

/// The box of all triangles in all lanes.
[[gnu::always_inline]] inline Boxes16 repeat_box(const ClusterGridBoxes& boxes) {
  const auto &low = boxes.all_low, &high = boxes.all_high;
  return {{Short16(low[0]), Short16(low[1]), Short16(low[2])},
          {Short16(high[0]), Short16(high[1]), Short16(high[2])}};
}

/// Returns the lanes whose boxes overlap, one bit per lane.
[[gnu::always_inline]] inline unsigned overlapping(const Boxes16& a, const Boxes16& b) {
  const Mask16 x = (a.low[0] > b.high[0]) | (b.low[0] > a.high[0]);
  const Mask16 y = (a.low[1] > b.high[1]) | (b.low[1] > a.high[1]);
  const Mask16 z = (a.low[2] > b.high[2]) | (b.low[2] > a.high[2]);
  return ~(x | y | z).bits() & 0xFFFF;
}

class GridBoxes {
 public:
  /// `cluster_nodes`: [C] node of each cluster. `memory`: cleared first. Precondition: all nodes
  /// are open, and the root box is known.
  GridBoxes(const PosedTree& posed, const std::uint32_t* cluster_nodes, Arena& memory);

  const ClusterGridBoxes& operator[](std::uint32_t cluster) const {
    if (!is_known_[cluster]) compute(cluster);
    return boxes_[cluster];
  }

 private:
  void compute(std::uint32_t cluster) const;
  std::int16_t round_one(float x, int axis) const;

  const PosedTree& posed_;
  const std::uint32_t* cluster_nodes_;
  float centre_[3], steps_[3];  // steps per unit of length
  ClusterGridBoxes* boxes_;     // [C]
  bool* is_known_;              // [C]
};

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail

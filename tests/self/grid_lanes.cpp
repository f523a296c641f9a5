/// Compiled once for each instruction set. The test itself runs on any machine.
#include "grid_lanes.hpp"

#include "pose/open_node.hpp"
#include "self/grid_boxes.hpp"

#include <cstring>

namespace pelt::test {
namespace PELT_INSTRUCTION_SET {

GridBoxesOfCluster grid_boxes(const detail::PosedTree& posed, const std::uint32_t* cluster_nodes,
                              std::uint32_t cluster, std::uint32_t other) {
  detail::Arena memory;
  const detail::GridBoxes grid(posed, cluster_nodes, memory);
  const detail::ClusterGridBoxes& boxes = grid[cluster];
  GridBoxesOfCluster result = {};
  detail::TriangleBoxes exact;
  compute_triangle_boxes(posed.tree, posed.tree.clusters[cluster],
                         posed.opened[cluster_nodes[cluster]]->positions, exact);
  std::memcpy(result.exact_low, exact.low, sizeof result.exact_low);
  std::memcpy(result.exact_high, exact.high, sizeof result.exact_high);
  std::memcpy(result.low, boxes.low, sizeof result.low);
  std::memcpy(result.high, boxes.high, sizeof result.high);
  std::memcpy(result.all_low, boxes.all_low, sizeof result.all_low);
  std::memcpy(result.all_high, boxes.all_high, sizeof result.all_high);
  result.triangles = boxes.triangles;
  for (unsigned i = 0; i < 16; ++i)
    result.overlapping[i] = overlapping(load_boxes(grid[other]), repeat_box(boxes, i));
  return result;
}

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::test

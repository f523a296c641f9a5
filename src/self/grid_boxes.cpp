#include "self/grid_boxes.hpp"

#include "pose/open_node.hpp"

#include <cmath>
#include <cstring>

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {
namespace {

constexpr float kMostSteps = 32767;

/// An axis along which the pose is so flat that this overflows gets no steps: all boxes overlap
/// along it.
float steps_per_length(float length) {
  const float steps = 2 * kMostSteps / length;
  return steps < HUGE_VALF ? steps : 0;
}

Float8 clamp(const Float8& steps) {
  return max(min(steps, Float8(kMostSteps)), Float8(-kMostSteps));
}

}  // namespace

GridBoxes::GridBoxes(const PosedTree& posed, const std::uint32_t* cluster_nodes, Arena& memory)
    : posed_(posed), cluster_nodes_(cluster_nodes) {
  const RootBox& root = posed.root_box;
  for (int axis = 0; axis < 3; ++axis) {
    centre_[axis] = 0.5f * root.low[axis] + 0.5f * root.high[axis];
    steps_[axis] = steps_per_length(root.high[axis] - root.low[axis]);
  }
  const std::size_t count = posed.tree.clusters.size();
  memory.reserve(grid_box_bytes(count));
  memory.clear();
  boxes_ = reinterpret_cast<ClusterGridBoxes*>(memory.allocate(count * sizeof(ClusterGridBoxes)));
  is_known_ = reinterpret_cast<bool*>(memory.allocate(count));
  std::memset(is_known_, 0, count);
}

/// Takes the same steps as for a lane in `compute`, so that the box of a cluster contains those of
/// its triangles.
std::int16_t GridBoxes::round_one(float x, int axis) const {
  const float steps = (x - centre_[axis]) * steps_[axis];
  const float below = steps < kMostSteps ? steps : kMostSteps;
  return static_cast<std::int16_t>(below > -kMostSteps ? below : -kMostSteps);
}

void GridBoxes::compute(std::uint32_t number) const {
  const Cluster& cluster = posed_.tree.clusters.data()[number];
  const std::uint32_t node = cluster_nodes_[number];
  const OpenedNode& opened = *posed_.opened[node];
  const std::uint32_t slot = number - posed_.tree.nodes.data()[node].first_cluster;
  TriangleBoxes exact;
  compute_triangle_boxes(posed_.tree, cluster, opened.positions, exact);
  ClusterGridBoxes& boxes = boxes_[number];
  for (int axis = 0; axis < 3; ++axis) {
    const Float8 centre(centre_[axis]), steps(steps_[axis]);
    const auto round = [&](const float(&bound)[kMaxClusterTriangles]) {
      return truncate(clamp((load8(bound) - centre) * steps),
                      clamp((load8(bound + 8) - centre) * steps));
    };
    const Short16 low = round(exact.low[axis]), high = round(exact.high[axis]);
    low.store(boxes.low[axis]);
    high.store(boxes.high[axis]);
    boxes.all_low[axis] = round_one(opened.low[axis][slot], axis);
    boxes.all_high[axis] = round_one(opened.high[axis][slot], axis);
  }
  boxes.triangles = static_cast<std::uint16_t>((1u << cluster.triangle_count) - 1);
  is_known_[number] = true;
}

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail

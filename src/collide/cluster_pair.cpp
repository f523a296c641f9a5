#include "collide/cluster_pair.hpp"

#include "pose/open_node.hpp"
#include "query/slots.hpp"

#include <bit>

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {
namespace {

Box8 intersection(const PosedCluster& a, const PosedCluster& b) {
  const Box8 box_a = lane_box(a.opened.low, a.opened.high, a.slot);
  const Box8 box_b = lane_box(b.opened.low, b.opened.high, b.slot);
  Box8 both;
  for (int axis = 0; axis < 3; ++axis) {
    both.low[axis] = max(box_a.low[axis], box_b.low[axis]);
    both.high[axis] = min(box_a.high[axis], box_b.high[axis]);
  }
  return both;
}

/// Returns the candidates whose boxes overlap `box`, one bit per candidate.
unsigned overlapping(unsigned candidates, const TriangleBoxes& boxes, const Box8& box) {
  return candidates & (overlapping(boxes.low, boxes.high, 0, box) |
                       overlapping(boxes.low, boxes.high, 8, box) << 8);
}

/// Returns the triangles of a cluster whose boxes overlap `box`, one bit per triangle.
unsigned triangles_in(const Cluster& cluster, const TriangleBoxes& boxes, const Box8& box) {
  return overlapping((1u << cluster.triangle_count) - 1, boxes, box);
}

RowLanes overlapping_pairs(unsigned near_rows, const TriangleBoxes& rows, unsigned near_lanes,
                           const TriangleBoxes& lanes) {
  RowLanes pairs;
  for (SetBits row(near_rows); row; ++row)
    pairs.add(*row, overlapping(near_lanes, lanes, lane_box(rows.low, rows.high, *row)));
  return pairs;
}

}  // namespace

void WaitingPairs::add(const PosedCluster& a, const PosedCluster& b) {
  const TriangleBoxes& boxes_a = triangle_boxes(a.posed, a.node, a.opened, a.slot);
  const TriangleBoxes& boxes_b = triangle_boxes(b.posed, b.node, b.opened, b.slot);
  const Box8 both = intersection(a, b);
  const unsigned near_a = triangles_in(a.cluster(), boxes_a, both);
  const unsigned near_b = triangles_in(b.cluster(), boxes_b, both);
  if (near_a == 0 || near_b == 0) return;
  if (std::popcount(near_a) <= std::popcount(near_b)) {
    add(overlapping_pairs(near_a, boxes_a, near_b, boxes_b), a, a_, b, b_);
  } else {
    add(overlapping_pairs(near_b, boxes_b, near_a, boxes_a), b, b_, a, a_);
  }
}

void WaitingPairs::add(const RowLanes& pairs, const PosedCluster& row_cluster, Side& rows,
                       const PosedCluster& lane_cluster, Side& lanes) {
  for (std::uint32_t i = 0; i < pairs.size(); ++i) {
    rows.triangle[count_ + i] = row_cluster.cluster().first_triangle + pairs.row(i);
    rows.positions[count_ + i] = row_cluster.opened.positions;
    lanes.triangle[count_ + i] = lane_cluster.cluster().first_triangle + pairs.lane(i);
    lanes.positions[count_ + i] = lane_cluster.opened.positions;
  }
  count_ += pairs.size();
}

WaitingPairs::Found WaitingPairs::test(std::uint32_t first, std::uint32_t count) {
  for (std::uint32_t i = count; i < kBatch; ++i) {
    a_.copy(first, first + i);
    b_.copy(first, first + i);
  }
  TrianglePairs8 pairs;
  a_.corners8(first, pairs.a);
  b_.corners8(first, pairs.b);
  const unsigned kept = (1u << count) - 1;
  const Triage verdict = triage(pairs);
  const auto corners_a = [&](unsigned lane) { return a_.corners(first + lane); };
  const auto corners_b = [&](unsigned lane) { return b_.corners(first + lane); };
  return {kept & verdict.intersecting, decide_exactly(verdict, kept, corners_a, corners_b)};
}

void WaitingPairs::drop(std::uint32_t first) {
  count_ -= first;
  for (std::uint32_t i = 0; i < count_; ++i) {
    a_.copy(first + i, i);
    b_.copy(first + i, i);
  }
}

TriangleCorners WaitingPairs::Side::corners(std::uint32_t i) const {
  return corners_at([&](std::size_t k) { return corner(i, k); });
}

void WaitingPairs::Side::corners8(std::uint32_t first, Points8 (&corners)[3]) const {
  for (std::size_t k = 0; k < 3; ++k)
    corners[k] = gather_points([&](std::uint32_t lane) { return corner(first + lane, k); });
}

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail

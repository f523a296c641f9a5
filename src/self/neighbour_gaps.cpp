#include "self/neighbour_gaps.hpp"

#include "pose/open_node.hpp"
#include "query/slots.hpp"
#include "query/triangle_batch.hpp"
#include "self/triangle_separation.hpp"

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {
namespace {

/// Gaps are measured up to this fraction of the sum of the sides of a cluster's box.
constexpr float kReach = 0.03f;

float reach_of(const PosedCluster& cluster) {
  float size = 0;
  for (int axis = 0; axis < 3; ++axis)
    size += cluster.opened.high[axis][cluster.slot] - cluster.opened.low[axis][cluster.slot];
  return size * kReach;
}

template <std::size_t kCount>
Box8 wide_box(const float (&low)[3][kCount], const float (&high)[3][kCount], unsigned lane,
              float reach) {
  return {
      {Float8(low[0][lane] - reach), Float8(low[1][lane] - reach), Float8(low[2][lane] - reach)},
      {Float8(high[0][lane] + reach), Float8(high[1][lane] + reach),
       Float8(high[2][lane] + reach)}};
}

unsigned triangles_in(const TriangleBoxes& boxes, const Box8& box) {
  return overlapping(boxes.low, boxes.high, 0, box) | overlapping(boxes.low, boxes.high, 8, box)
                                                          << 8;
}

unsigned all_triangles(const PosedCluster& cluster) {
  return (1u << cluster.cluster().triangle_count) - 1;
}

/// Lists the pairs that are not skipped and whose boxes overlap if one is widened by `reach`. All
/// others are more than `reach` apart, up to rounding.
RowLanes near_pairs(const PosedCluster& a, const PosedCluster& b,
                    const std::uint16_t (&skipped)[kMaxClusterTriangles], float reach) {
  const TriangleBoxes& boxes_a = triangle_boxes(a.posed, a.node, a.opened, a.slot);
  const TriangleBoxes& boxes_b = triangle_boxes(b.posed, b.node, b.opened, b.slot);
  const unsigned near_a =
      all_triangles(a) &
      triangles_in(boxes_a, wide_box(b.opened.low, b.opened.high, b.slot, reach));
  const unsigned near_b =
      all_triangles(b) &
      triangles_in(boxes_b, wide_box(a.opened.low, a.opened.high, a.slot, reach));
  RowLanes pairs;
  for (SetBits row(near_a); row; ++row) {
    const unsigned lanes = near_b & ~unsigned{skipped[*row]};
    pairs.add(*row,
              lanes & triangles_in(boxes_b, wide_box(boxes_a.low, boxes_a.high, *row, reach)));
  }
  return pairs;
}

/// Returns one corner of eight triangles of a cluster.
template <typename TriangleOf>
Points8 corner8(const PosedCluster& cluster, std::size_t corner, const TriangleOf& triangle_of) {
  const auto* corners = cluster.posed.tree.corners.data() + cluster.cluster().first_triangle;
  return gather_points([&](std::uint32_t lane) {
    return cluster.opened.positions + corners[triangle_of(lane)][corner];
  });
}

/// Returns lower bounds of the distances of eight listed pairs, from number `first` on. Lanes
/// beyond the end repeat the last pair.
Float8 separations8(const PosedCluster& a, const PosedCluster& b, const RowLanes& pairs,
                    std::uint32_t first) {
  const std::uint32_t last = pairs.size() - 1;
  const auto at = [&](std::uint32_t lane) { return first + lane < last ? first + lane : last; };
  TrianglePairs8 eight;
  for (std::size_t k = 0; k < 3; ++k) {
    eight.a[k] = corner8(a, k, [&](std::uint32_t lane) { return pairs.row(at(lane)); });
    eight.b[k] = corner8(b, k, [&](std::uint32_t lane) { return pairs.lane(at(lane)); });
  }
  return separations(eight);
}

}  // namespace

float test_gaps(const PosedCluster& a, const PosedCluster& b,
                const std::uint16_t (&skipped)[kMaxClusterTriangles], float extent,
                TrianglePairs& pairs, QueryStats& work) {
  const float reach_a = reach_of(a), reach_b = reach_of(b);
  const float reach = reach_a < reach_b ? reach_a : reach_b;
  const RowLanes near = near_pairs(a, b, skipped, reach);
  float least = reach - 0x1p-20f * (extent + reach);  // low - reach and high + reach are rounded
  RowLanes close;
  for (std::uint32_t first = 0; first < near.size(); first += kBatch) {
    float gaps[kBatch];
    separations8(a, b, near, first).store(gaps);
    for (std::uint32_t i = first; i < near.size() && i < first + kBatch; ++i) {
      const float gap = gaps[i - first];
      if (!(gap > 0)) close.add(near.row(i), 1u << near.lane(i));
      least = gap < least ? gap : least;
    }
  }
  work.triangle_pairs += near.size();
  if (close.size() > 0) pairs.add(a, b, close);
  return least > 0 ? least : 0;
}

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail

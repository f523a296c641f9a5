#include "self/neighbour_gaps.hpp"

#include "geometry/points8.hpp"
#include "pose/open_node.hpp"
#include "query/slots.hpp"
#include "query/triangle_batch.hpp"

#include <initializer_list>

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {
namespace {

/// The gap between the projections of two triangles onto a direction n, divided by |n|, is a lower
/// bound of their distance.
///
/// Rounding. All corners are taken relative to one of them, and divided by the largest coordinate L
/// of these. With e = 2^-24, the computed reciprocal of L has a relative error of e, which changes
/// only the scale, by the same factor for all corners. n is any float vector. A position along n
/// has an error of at most 5.1 e |n|_1: two roundings of the corner, one of a product, two of sums.
/// The difference of two positions is at most 2 |n|_1 and is rounded once more, so its error is
/// below 13 e |n|_1. The margin 2^-19 |n|_1 = 32 e |n|_1 is more than twice that.
///
/// gap^2 / n^2 has at most 7 relative errors e. The root halves them and adds one. The scale, and
/// the products with L and with 1 - 2^-20, add three. These are 7.5 e, and 1 - 2^-20 = 1 - 16 e
/// covers them.
///
/// Products that underflow add at most 2^-149 |n|_1 each, which the margin covers. If the area is
/// zero, or the reciprocal of L or of the area's largest coordinate overflows, then all coordinates
/// of n are NaN or infinite. Then n^2 fails its test, whatever min and max make of a NaN.
Points8 abs8(const Points8& p) { return {abs(p.x), abs(p.y), abs(p.z)}; }
Float8 largest_of(const Points8& p) { return max(max(abs(p.x), abs(p.y)), abs(p.z)); }
Float8 min3(const Float8& a, const Float8& b, const Float8& c) { return min(min(a, b), c); }
Float8 max3(const Float8& a, const Float8& b, const Float8& c) { return max(max(a, b), c); }
class Separation {
 public:
  explicit Separation(const TrianglePairs8& pairs)
      : a1_(pairs.a[1] - pairs.a[0]),
        a2_(pairs.a[2] - pairs.a[0]),
        b0_(pairs.b[0] - pairs.a[0]),
        b1_(pairs.b[1] - pairs.a[0]),
        b2_(pairs.b[2] - pairs.a[0]),
        size_(max(max(largest_of(a1_), largest_of(a2_)),
                  max3(largest_of(b0_), largest_of(b1_), largest_of(b2_)))) {
    const Float8 scale = Float8(1.0f) / size_;
    for (Points8* p : {&a1_, &a2_, &b0_, &b1_, &b2_}) *p = scale * *p;
  }

  void try_plane_of(const Points8& edge0, const Points8& edge1, const Points8& edge2) {
    const Points8 area = cross(edge0, edge1);
    const Points8 normal = Float8(1.0f) / largest_of(area) * area;
    try_direction(normal);
    try_direction(cross(edge0, normal));
    try_direction(cross(edge1, normal));
    try_direction(cross(edge2, normal));
  }

  Float8 largest() {
    try_plane_of(a1_, a2_ - a1_, a2_);
    try_plane_of(b1_ - b0_, b2_ - b1_, b2_ - b0_);
    return select(Float8(0.0f) < squared_, sqrt(squared_) * size_ * Float8(1 - 0x1p-20f),
                  Float8(0.0f));
  }

 private:
  void try_direction(const Points8& n) {
    const Float8 a1 = dot(n, a1_), a2 = dot(n, a2_), zero(0.0f);
    const Float8 b0 = dot(n, b0_), b1 = dot(n, b1_), b2 = dot(n, b2_);
    const Float8 beyond = min3(b0, b1, b2) - max3(a1, a2, zero);
    const Float8 before = min3(a1, a2, zero) - max3(b0, b1, b2);
    const Points8 sizes = abs8(n);
    const Float8 gap = max(beyond, before) - Float8(0x1p-19f) * (sizes.x + sizes.y + sizes.z);
    const Float8 squared_n = dot(n, n);
    const Mask8 is_certain = (Float8(0x1p-50f) < gap) & (gap < Float8(0x1p50f)) &
                             (Float8(0x1p-100f) < squared_n) & (squared_n < Float8(0x1p100f));
    squared_ = select(is_certain, max(squared_, gap * gap / squared_n), squared_);
  }

  Points8 a1_, a2_, b0_, b1_, b2_;  // relative to the first corner of a, divided by size_
  Float8 size_;
  Float8 squared_ = Float8(0.0f);
};

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
  return Separation(eight).largest();
}

}  // namespace

Float8 separations(const TrianglePairs8& pairs) { return Separation(pairs).largest(); }

float test_gaps(const PosedCluster& a, const PosedCluster& b,
                const std::uint16_t (&skipped)[kMaxClusterTriangles], float extent,
                SelfTrianglePairs& pairs, QueryStats& work) {
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

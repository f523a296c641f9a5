#include "query/cluster_pair.hpp"

#include "geometry/triangle_pair.hpp"
#include "geometry/triangle_triage.hpp"
#include "pose/open_node.hpp"
#include "query/lanes.hpp"

namespace pelt::detail {
inline namespace PELT_TARGET {
namespace {

/// Which of the 16 triangles' boxes overlap `box`, one bit each.
unsigned overlapping(const TriangleBoxes& boxes, const Box8& box) {
  return overlapping(boxes.low, boxes.high, 0, box) | overlapping(boxes.low, boxes.high, 8, box)
                                                          << 8;
}

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

TriangleCorners corners(const float* const (&corner)[3]) {
  TriangleCorners triangle;
  for (int i = 0; i < 3; ++i) triangle[i] = {corner[i][0], corner[i][1], corner[i][2]};
  return triangle;
}

}  // namespace

void TrianglePairs::add(const PosedCluster& a, const PosedCluster& b) {
  const TriangleBoxes& boxes_a = triangle_boxes(a.posed, a.node, a.opened, a.slot);
  const TriangleBoxes& boxes_b = triangle_boxes(b.posed, b.node, b.opened, b.slot);
  const Box8 both = intersection(a, b);
  const unsigned near_a = overlapping(boxes_a, both);
  if (near_a == 0) return;
  const unsigned near_b = overlapping(boxes_b, both);
  if (near_b == 0) return;
  if (std::popcount(near_a) <= std::popcount(near_b)) {
    for (SetBits i(near_a); i; ++i)
      for (SetBits k(near_b & overlapping(boxes_b, lane_box(boxes_a.low, boxes_a.high, *i))); k;
           ++k)
        keep(a, *i, b, *k);
  } else {
    for (SetBits k(near_b); k; ++k)
      for (SetBits i(near_a & overlapping(boxes_a, lane_box(boxes_b.low, boxes_b.high, *k))); i;
           ++i)
        keep(a, *i, b, *k);
  }
}

void TrianglePairs::keep(const PosedCluster& a, std::uint32_t triangle_a, const PosedCluster& b,
                         std::uint32_t triangle_b) {
  const std::uint32_t index_a = a.cluster().first_triangle + triangle_a;
  const std::uint32_t index_b = b.cluster().first_triangle + triangle_b;
  const std::array<std::uint16_t, 3>& corners_a = a.posed.tree.corners[index_a];
  const std::array<std::uint16_t, 3>& corners_b = b.posed.tree.corners[index_b];
  Candidate& candidate = kept_[kept_count_++];
  for (int i = 0; i < 3; ++i) {
    candidate.a[i] = a.opened.positions + 4 * corners_a[i];
    candidate.b[i] = b.opened.positions + 4 * corners_b[i];
  }
  candidate.ids = {a.posed.tree.triangle_ids[index_a], b.posed.tree.triangle_ids[index_b]};
  if (kept_count_ == 8) flush();
}

void TrianglePairs::flush() {
  if (kept_count_ == 0) return;
  for (std::uint32_t lane = kept_count_; lane < 8; ++lane) kept_[lane] = kept_[0];
  TrianglePairs8 pairs;
  const auto gather = [&](const float*(Candidate::*corners)[3], int i) {
    const auto at = [&](int lane) { return load4((kept_[lane].*corners)[i]); };
    return transpose8(at(0), at(1), at(2), at(3), at(4), at(5), at(6), at(7));
  };
  for (int i = 0; i < 3; ++i) {
    pairs.a[i] = gather(&Candidate::a, i);
    pairs.b[i] = gather(&Candidate::b, i);
  }
  const unsigned real = (1u << kept_count_) - 1;
  const Triage verdict = triage(pairs);
  for (SetBits lane(real & verdict.intersecting); lane; ++lane) contacts_.push(kept_[*lane].ids);
  for (SetBits lane(real & ~(verdict.intersecting | verdict.apart)); lane; ++lane)
    if (triangles_intersect(corners(kept_[*lane].a), corners(kept_[*lane].b)))
      contacts_.push(kept_[*lane].ids);
  work_.triangle_pairs += kept_count_;
  kept_count_ = 0;
}

}  // namespace PELT_TARGET
}  // namespace pelt::detail

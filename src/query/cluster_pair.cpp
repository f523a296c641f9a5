#include "query/cluster_pair.hpp"

#include "geometry/triangle_pair.hpp"
#include "geometry/triangle_triage.hpp"
#include "pose/open_node.hpp"
#include "query/lanes.hpp"

namespace pelt::detail {
inline namespace PELT_TARGET {
namespace {

/// The triangles of a cluster, by their numbers in it.
class ClusterTriangles {
 public:
  explicit ClusterTriangles(const PosedCluster& c)
      : boxes_(triangle_boxes(c.posed, c.node, c.opened, c.slot)),
        cluster_(c.posed.tree.clusters[c.node.first_cluster + c.slot]),
        positions_(c.opened.positions),
        corners_(c.posed.tree.corners[cluster_.first_triangle].data()),
        ids_(c.posed.tree.triangle_ids.data() + cluster_.first_triangle) {}

  /// One bit for each.
  unsigned all() const { return (1u << cluster_.triangle_count) - 1; }

  PosedTriangle operator[](unsigned triangle) const {
    return {positions_, corners_ + 3 * triangle, ids_ + triangle};
  }

  Box8 box(unsigned triangle) const { return lane_box(boxes_.low, boxes_.high, triangle); }

  /// Those of `candidates` whose boxes overlap `box`, one bit each.
  unsigned overlapping(unsigned candidates, const Box8& box) const {
    return candidates & (detail::overlapping(boxes_.low, boxes_.high, 0, box) |
                         detail::overlapping(boxes_.low, boxes_.high, 8, box) << 8);
  }

 private:
  const TriangleBoxes& boxes_;
  const Cluster& cluster_;
  const float* positions_;
  const std::uint16_t* corners_;
  const std::uint32_t* ids_;
};

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

TriangleCorners corners(const PosedTriangle& triangle) {
  TriangleCorners corners;
  for (int i = 0; i < 3; ++i) {
    const float* p = triangle.corner(i);
    corners[i] = {p[0], p[1], p[2]};
  }
  return corners;
}

Points8 corners8(const PosedTriangle (&triangles)[8], int i) {
  const auto at = [&](int lane) { return load4(triangles[lane].corner(i)); };
  return transpose8(at(0), at(1), at(2), at(3), at(4), at(5), at(6), at(7));
}

}  // namespace

void TrianglePairs::add(const PosedCluster& a, const PosedCluster& b) {
  const ClusterTriangles triangles_a(a), triangles_b(b);
  const Box8 both = intersection(a, b);
  const unsigned near_a = triangles_a.overlapping(triangles_a.all(), both);
  const unsigned near_b = triangles_b.overlapping(triangles_b.all(), both);
  if (near_a == 0 || near_b == 0) return;
  if (std::popcount(near_a) <= std::popcount(near_b)) {
    for (SetBits i(near_a); i; ++i)
      for (SetBits k(triangles_b.overlapping(near_b, triangles_a.box(*i))); k; ++k)
        keep(triangles_a[*i], triangles_b[*k]);
  } else {
    for (SetBits k(near_b); k; ++k)
      for (SetBits i(triangles_a.overlapping(near_a, triangles_b.box(*k))); i; ++i)
        keep(triangles_a[*i], triangles_b[*k]);
  }
}

void TrianglePairs::flush() {
  if (kept_count_ == 0) return;
  for (std::uint32_t lane = kept_count_; lane < 8; ++lane) {
    kept_a_[lane] = kept_a_[0];
    kept_b_[lane] = kept_b_[0];
  }
  TrianglePairs8 pairs;
  for (int i = 0; i < 3; ++i) {
    pairs.a[i] = corners8(kept_a_, i);
    pairs.b[i] = corners8(kept_b_, i);
  }
  const unsigned kept = (1u << kept_count_) - 1;
  const Triage verdict = triage(pairs);
  for (SetBits lane(kept & verdict.intersecting); lane; ++lane) report(*lane);
  for (SetBits lane(kept & ~(verdict.intersecting | verdict.apart)); lane; ++lane)
    if (triangles_intersect(corners(kept_a_[*lane]), corners(kept_b_[*lane]))) report(*lane);
  work_.triangle_pairs += kept_count_;
  kept_count_ = 0;
}

}  // namespace PELT_TARGET
}  // namespace pelt::detail

/// The descent of a tree that looks for the triangle nearest to a point: as that of two trees
/// (pair_search.cpp), with a point instead of the second.

#include "distance/point_search.hpp"

#include "distance/gaps.hpp"
#include "distance/nearest_parts.hpp"
#include "distance/part.hpp"
#include "distance/reach.hpp"
#include "distance/triangle_gaps.hpp"

#include <cmath>

namespace pelt::detail {
inline namespace PELT_TARGET {
namespace {

/// No less than any difference of a coordinate of the point and one of the pose.
double extent(const RootBox& box, const float (&point)[3]) {
  double most = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double low = box.low[axis] < point[axis] ? box.low[axis] : point[axis];
    const double high = box.high[axis] > point[axis] ? box.high[axis] : point[axis];
    most = high - low > most ? high - low : most;
  }
  return most;
}

class PointSearch {
 public:
  PointSearch(const PosedTree& posed, const Vec3& point, Scratch& scratch, double max_distance,
              PointGap& best)
      : posed_(posed),
        point_(point),
        box_{{Float8(point.x), Float8(point.y), Float8(point.z)},
             {Float8(point.x), Float8(point.y), Float8(point.z)}},
        parts_(scratch.near_part),
        max_distance_(max_distance),
        best_(best),
        reach_(extent(root_box(posed, work_), {point.x, point.y, point.z})) {
    reach_.set(max_distance);
  }

  QueryStats run() {
    parts_.clear();
    if (!is_near()) return work_;
    make_table(posed_);
    parts_.push({0, 0, Part::kWhole});
    while (!parts_.empty()) {
      const NearPart near = parts_.pop();
      if (near.squared_gap <= reach_.squared_gap()) visit({near.node, near.slot});
    }
    return work_;
  }

 private:
  bool is_near() {
    ++work_.node_pairs;
    const RootBox& root = root_box(posed_, work_);
    const Float8 gaps = squared_gap(point_box(root.low, root.high), box_);
    return ((gaps <= Float8(reach_.squared_gap())).bits() & 1) != 0;
  }

  void visit(const Part& part) {
    if (is_cluster(posed_, part)) return compare(cluster_of(posed_, part));
    ++work_.node_pairs;
    const std::uint32_t node = node_of(posed_, part);
    const OpenedNode& opened = open_node(posed_, node, work_);
    const Float8 gaps = squared_gaps(opened.low, opened.high, 0, box_);
    const unsigned near = (gaps <= Float8(reach_.squared_gap())).bits();
    push_nearest_last(parts_, near & slots_of(posed_.tree.nodes.data()[node]), gaps,
                      [&](unsigned slot, float gap) {
                        return NearPart{gap, node, slot};
                      });
  }

  void compare(const PosedCluster& cluster) {
    const TriangleBoxes& boxes =
        triangle_boxes(cluster.posed, cluster.node, cluster.opened, cluster.slot);
    TriangleValues gaps;
    squared_gaps(boxes.low, boxes.high, 0, box_).store(gaps.of);
    squared_gaps(boxes.low, boxes.high, 8, box_).store(gaps.of + 8);
    const std::uint32_t first = lowest_of(gaps);
    if (!(gaps.of[first] <= reach_.squared_gap())) return;
    measure(cluster, first);
    const unsigned others = ((1u << cluster.cluster().triangle_count) - 1) & ~(1u << first);
    for (SetBits triangle(others & up_to(gaps, reach_.squared_gap())); triangle; ++triangle)
      if (gaps.of[*triangle] <= reach_.squared_gap()) measure(cluster, *triangle);
  }

  void measure(const PosedCluster& cluster, std::uint32_t triangle) {
    ++work_.triangle_pairs;
    const std::uint32_t place = cluster.cluster().first_triangle + triangle;
    const TriangleCorners corners = corners_of(cluster, place);
    const NearestOnTriangle nearest = nearest_on_triangle(Vec3d(point_), corners);
    const std::uint32_t id = posed_.tree.triangle_ids.data()[place];
    if (!is_better(nearest.squared_distance, id)) return;
    best_ = {id, corners, nearest};
    reach_.set(std::sqrt(nearest.squared_distance));
  }

  bool is_better(double squared, std::uint32_t triangle) const {
    const double best = best_.nearest.squared_distance;
    if (squared == best) return triangle < best_.triangle;
    return squared < best && std::sqrt(squared) <= max_distance_;
  }

  const PosedTree& posed_;
  const Vec3 point_;
  const Box8 box_;          // around the point
  Stack<NearPart>& parts_;  // the one on top is next
  const double max_distance_;
  PointGap& best_;
  QueryStats work_;
  Reach reach_;
};

}  // namespace

QueryStats nearest_to_point(const PosedTree& posed, const Vec3& point, Scratch& scratch,
                            double max_distance, PointGap& nearest) {
  return PointSearch(posed, point, scratch, max_distance, nearest).run();
}

}  // namespace PELT_TARGET
}  // namespace pelt::detail

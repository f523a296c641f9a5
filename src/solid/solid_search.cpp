/// The descent of a tree that looks for the triangle nearest to a solid: as that of a point
/// (point_search.cpp), with lower bounds of boxes' distances from the solid.

#include "solid/solid_search.hpp"

#include "distance/nearest_parts.hpp"
#include "distance/part.hpp"
#include "distance/reach.hpp"
#include "distance/triangle_gaps.hpp"
#include "pose/open_node.hpp"
#include "region/box_gaps.hpp"

#include <cmath>

namespace pelt::detail {
inline namespace PELT_TARGET {
namespace {

/// No less than any coordinate of the pose.
double extent(const RootBox& box) {
  double most = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double low = std::fabs(box.low[axis]), high = std::fabs(box.high[axis]);
    const double larger = low < high ? high : low;
    most = most < larger ? larger : most;
  }
  return most;
}

/// `Gaps` tells lower bounds of the squared distances of eight boxes.
template <typename Gaps>
class SolidSearch {
 public:
  SolidSearch(const PosedTree& posed, const PreparedSolid& solid, const Gaps& gaps,
              Scratch& scratch, double max_distance, SolidGap& best)
      : posed_(posed),
        solid_(solid.solid),
        gaps_(gaps),
        parts_(scratch.near_part),
        max_distance_(max_distance),
        best_(best),
        reach_(2 * (extent(root_box(posed, work_)) + solid.extent)) {
    reach_.set(max_distance);
  }

  QueryStats run() {
    parts_.clear();
    ++work_.node_pairs;
    const RootBox& root = root_box(posed_, work_);
    const Box8 box = point_box(root.low, root.high);
    if ((near(gaps_(
             {{box.low[0], box.low[1], box.low[2]}, {box.high[0], box.high[1], box.high[2]}})) &
         1) == 0)
      return work_;
    make_table(posed_);
    parts_.push({0, 0, Part::kWhole});
    while (!parts_.empty()) {
      const NearPart part = parts_.pop();
      if (part.squared_gap <= reach_.squared_gap()) visit({part.node, part.slot});
    }
    return work_;
  }

 private:
  unsigned near(const Float8& gaps) const { return (gaps <= Float8(reach_.squared_gap())).bits(); }

  void visit(const Part& part) {
    if (is_cluster(posed_, part)) return compare(cluster_of(posed_, part));
    ++work_.node_pairs;
    const std::uint32_t node = node_of(posed_, part);
    const OpenedNode& opened = open_node(posed_, node, work_);
    const Float8 gaps = gaps_(load_boxes(opened.low, opened.high, 0));
    push_nearest_last(parts_, near(gaps) & slots_of(posed_.tree.nodes.data()[node]), gaps,
                      [&](unsigned slot, float gap) {
                        return NearPart{gap, node, slot};
                      });
  }

  void compare(const PosedCluster& cluster) {
    const TriangleBoxes& boxes =
        triangle_boxes(cluster.posed, cluster.node, cluster.opened, cluster.slot);
    TriangleValues gaps;
    gaps_(load_boxes(boxes.low, boxes.high, 0)).store(gaps.of);
    gaps_(load_boxes(boxes.low, boxes.high, 8)).store(gaps.of + 8);
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
    const SolidPoints points = nearest_points(corners, solid_);
    const std::uint32_t id = posed_.tree.triangle_ids.data()[place];
    if (!is_better(points.distance, id)) return;
    best_ = {id, corners, points};
    reach_.set(points.distance);
  }

  bool is_better(double distance, std::uint32_t triangle) const {
    const double best = best_.nearest.distance;
    if (distance == best) return triangle < best_.triangle;
    return distance < best && distance <= max_distance_;
  }

  const PosedTree& posed_;
  const Solid& solid_;
  const Gaps& gaps_;
  Stack<NearPart>& parts_;  // the one on top is next
  const double max_distance_;
  SolidGap& best_;
  QueryStats work_;
  Reach reach_;
};

}  // namespace

QueryStats nearest_to_solid(const PosedTree& posed, const PreparedSolid& solid, Scratch& scratch,
                            double max_distance, SolidGap& nearest) {
  const auto search = [&](const auto& gaps) {
    return SolidSearch(posed, solid, gaps, scratch, max_distance, nearest).run();
  };
  return solid.region.is_capsule ? search(CapsuleGaps(solid.region.capsule))
                                 : search(FacesGaps(solid.region.faces));
}

}  // namespace PELT_TARGET
}  // namespace pelt::detail

#pragma once

/// Nearest-first descent of a tree for the triangle closest to a point or a solid. Like the descent
/// of two trees (distance_search.cpp), with the point or solid instead of the second tree.

#include "distance/triangle_gaps.hpp"
#include "pose/open_node.hpp"
#include "query/nearest_search.hpp"
#include "query/scratch.hpp"

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {

/// `Goal` stores the best triangle so far, and provides
///   double extent(const RootBox&) const: an upper bound of any difference of two coordinates;
///   Float8 squared_gaps(const Boxes8&) const: lower bounds for eight boxes, with the error that
///     `Reach` assumes;
///   bool takes(triangle, corners): stores the triangle if it is better; returns whether it is;
///   double reach() const: the distance below which a triangle is better.
template <typename Goal>
class TriangleSearch {
 public:
  TriangleSearch(const PosedTree& posed, Scratch& scratch, Goal& goal)
      : posed_(posed),
        parts_(scratch.near_part),
        goal_(goal),
        reach_(goal.extent(root_box(posed, work_))) {
    reach_.set(goal.reach());
  }

  QueryStats run() {
    parts_.clear();
    ++work_.node_pairs;
    const RootBox& root = root_box(posed_, work_);
    if ((near(goal_.squared_gaps(repeat(point_box(root.low, root.high)))) & 1) == 0) return work_;
    make_table(posed_);
    parts_.push({0, 0, TreePart::kWhole});
    while (!parts_.empty()) {
      const NearPart part = parts_.pop();
      if (part.squared_gap <= reach_.squared_gap()) visit({part.node, part.slot});
    }
    return work_;
  }

 private:
  unsigned near(const Float8& gaps) const { return (gaps <= Float8(reach_.squared_gap())).bits(); }

  void visit(const TreePart& part) {
    if (is_cluster(posed_, part)) return compare(cluster_of(posed_, part));
    ++work_.node_pairs;
    const std::uint32_t node = node_of(posed_, part);
    const OpenedNode& opened = open_node(posed_, node, work_);
    const Float8 gaps = goal_.squared_gaps(load_boxes(opened.low, opened.high, 0));
    push_nearest_last(parts_, near(gaps) & slots_of(posed_.tree.nodes.data()[node]), gaps,
                      [&](unsigned slot, float gap) {
                        return NearPart{gap, node, slot};
                      });
  }

  /// Tests the triangle with the closest box first.
  void compare(const PosedCluster& cluster) {
    const TriangleBoxes& boxes =
        triangle_boxes(cluster.posed, cluster.node, cluster.opened, cluster.slot);
    TriangleValues gaps;
    goal_.squared_gaps(load_boxes(boxes.low, boxes.high, 0)).store(gaps.of);
    goal_.squared_gaps(load_boxes(boxes.low, boxes.high, 8)).store(gaps.of + 8);
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
    if (goal_.takes(posed_.tree.triangle_ids.data()[place], corners_of(cluster, place)))
      reach_.set(goal_.reach());
  }

  const PosedTree& posed_;
  Stack<NearPart>& parts_;  // the top is visited next
  Goal& goal_;
  QueryStats work_;
  Reach reach_;
};

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail

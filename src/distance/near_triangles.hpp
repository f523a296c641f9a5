#pragma once

/// The triangles of two clusters that may be within reach. Two lower bounds are computed for all
/// pairs: the gap of their boxes, and their gap along the direction of the best pair so far,
/// because most pairs that are equally near have nearly this direction. The remaining pairs wait
/// until there are eight, whose distances are computed at once (triangle_gaps.hpp).
///
/// A goal decides which pairs are needed:
///   double reach() const      the distance beyond which pairs are useless; it may only decrease
///   bool keeps_best() const   whether it needs a single pair, the best, with its closest points,
///                             instead of all pairs
///   bool wants(gap) const     whether it needs a pair whose closest points are not yet known
///   void take(gap)            adds a pair that it needs
///   bool is_done() const      no more pairs are needed

#include "distance/distance_search.hpp"
#include "distance/triangle_gaps.hpp"
#include "pose/open_node.hpp"
#include "query/nearest_search.hpp"
#include "query/slots.hpp"
#include "query/triangle_batch.hpp"

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {

template <typename Goal>
class NearTriangles {
 public:
  NearTriangles(Goal& goal, double extent, QueryStats& work)
      : goal_(goal), reach_(extent), work_(work) {
    reach_.set(goal_.reach());
  }

  const Reach& reach() const { return reach_; }

  /// Adds the pairs of two clusters' triangles: passes them to the goal, or stores them.
  void add(const PosedCluster& a, const PosedCluster& b, const ClusterSlots& slots) {
    const Vec3 origin = low_corner(a);
    const float error = gap_error(a, b, origin);
    const TriangleBoxes& boxes_a = triangle_boxes(a.posed, a.node, a.opened, a.slot);
    const TriangleBoxes& boxes_b = triangle_boxes(b.posed, b.node, b.opened, b.slot);
    const unsigned near_a = within_reach(boxes_a, all_of(a), box_of(b));
    const unsigned near_b = near_a == 0 ? 0 : within_reach(boxes_b, all_of(b), box_of(a));
    if (near_b == 0) return;
    const Along along(has_way_ ? way_ : direction_between(a, b), origin);
    const TriangleValues high = along.highest(a), low = along.lowest(b);
    if (!has_way_ && goal_.keeps_best()) {
      keep(pair_of(a, highest_of(high), b, lowest_of(low), slots));
      flush();
    }
    for (SetBits row(near_a); row && !goal_.is_done(); ++row) {
      const unsigned lanes = near_b & up_to(low, high.of[*row] + reach_.gap() + error);
      if (lanes == 0) continue;
      const Box8 box = lane_box(boxes_a.low, boxes_a.high, *row);
      for (SetBits lane(within_reach(boxes_b, lanes, box)); lane; ++lane)
        keep(pair_of(a, *row, b, *lane, slots));
    }
    if (!has_way_ || !goal_.keeps_best()) flush();
  }

  /// Passes the stored pairs to the goal, nearest first.
  void flush() {
    if (waiting_.count() == 0) return;
    double squared[kBatch];
    measure(squared);
    unsigned left = (1u << waiting_.count()) - 1;
    while (left != 0 && !goal_.is_done()) {
      unsigned next = *SetBits(left);
      for (SetBits lane(left); lane; ++lane)
        if (squared[*lane] < squared[next]) next = *lane;
      left &= ~(1u << next);
      offer(waiting_[next], squared[next]);
    }
    waiting_.clear();
  }

 private:
  /// A triangle of each tree.
  struct Pair {
    const PosedTree *tree_a, *tree_b;
    const float *positions_a, *positions_b;  ///< of the pools
    std::uint32_t triangle_a, triangle_b;    ///< into Tree::corners
    ClusterSlots slots;
  };

  static Pair pair_of(const PosedCluster& a, unsigned i, const PosedCluster& b, unsigned j,
                      const ClusterSlots& slots) {
    return {&a.posed,
            &b.posed,
            a.opened.positions,
            b.opened.positions,
            a.cluster().first_triangle + i,
            b.cluster().first_triangle + j,
            slots};
  }

  static unsigned all_of(const PosedCluster& c) { return (1u << c.cluster().triangle_count) - 1; }

  static Box8 box_of(const PosedCluster& c) {
    return lane_box(c.opened.low, c.opened.high, c.slot);
  }

  unsigned within_reach(const TriangleBoxes& boxes, unsigned lanes, const Box8& box) const {
    const Float8 most(reach_.squared_gap());
    return lanes & ((squared_gaps(boxes.low, boxes.high, 0, box) <= most).bits() |
                    (squared_gaps(boxes.low, boxes.high, 8, box) <= most).bits() << 8);
  }

  void keep(const Pair& pair) {
    waiting_.add(pair);
    if (waiting_.is_full()) flush();
  }

  void measure(double (&squared)[kBatch]) {
    work_.triangle_pairs += waiting_.count();
    waiting_.pad();
    TrianglePairs8 pairs;
    for (std::size_t k = 0; k < 3; ++k) {
      pairs.a[k] = gather_points([&](std::uint32_t i) {
        return corner(*waiting_[i].tree_a, waiting_[i].positions_a, waiting_[i].triangle_a, k);
      });
      pairs.b[k] = gather_points([&](std::uint32_t i) {
        return corner(*waiting_[i].tree_b, waiting_[i].positions_b, waiting_[i].triangle_b, k);
      });
    }
    squared_distances(pairs, waiting_.count(), squared);
  }

  static const float* corner(const PosedTree& posed, const float* positions, std::uint32_t triangle,
                             std::size_t k) {
    return positions + posed.tree.corners.data()[triangle][k];
  }

  void offer(const Pair& pair, double squared) {
    TriangleGap gap;
    gap.triangle_a = pair.tree_a->tree.triangle_ids.data()[pair.triangle_a];
    gap.triangle_b = pair.tree_b->tree.triangle_ids.data()[pair.triangle_b];
    gap.closest.squared_distance = squared;
    if (!goal_.wants(gap)) return;
    gap.corners_a = corners_at(
        [&](std::size_t k) { return corner(*pair.tree_a, pair.positions_a, pair.triangle_a, k); });
    gap.corners_b = corners_at(
        [&](std::size_t k) { return corner(*pair.tree_b, pair.positions_b, pair.triangle_b, k); });
    gap.slots = pair.slots;
    if (goal_.keeps_best()) gap.closest = closest_points(gap.corners_a, gap.corners_b);
    goal_.take(gap);
    if (!goal_.keeps_best()) return;
    reach_.set(goal_.reach());
    has_way_ = true;
    way_ = direction_of(point_at(gap.corners_b, gap.closest.b) -
                        point_at(gap.corners_a, gap.closest.a));
  }

  Goal& goal_;
  Reach reach_;
  QueryStats& work_;
  bool has_way_ = false;
  Vec3 way_;  ///< the direction of the best pair
  Batch8<Pair> waiting_;
};

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail

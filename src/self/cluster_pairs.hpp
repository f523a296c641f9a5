#pragma once

/// Tests the triangles of pairs of clusters of one character: ClusterPairs in a pose,
/// MovingClusterPairs in a step. Both have these functions, for SeparateTriangles (self_tree.cpp):
///
///   void add(std::uint32_t low, std::uint32_t high, const PairMask& skipped)
///                           tests two clusters, or a cluster and itself, without the skipped pairs
///                           of triangles, or stores them for the next test
///   void add_neighbours(std::uint32_t low, std::uint32_t high, std::uint32_t mask)
///                           the same without the pairs of mask number `mask` of PairMasks
///   bool are_apart(std::uint32_t mask) const     whether the tracker has proven that the triangles
///                           of these neighbours are apart
///   void test_boxes()       ends the use of the masks that were passed to `add`
///   void flush()            tests what is stored

#include "collide/cluster_pair.hpp"
#include "motion/moving_pairs.hpp"
#include "self/grid_boxes.hpp"
#include "self/neighbour_gaps.hpp"
#include "self/self_filter.hpp"
#include "self/self_track.hpp"

#include <cstring>

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {

/// Pairs of clusters wait until there are sixteen. A list of the rows of all of them, which is
/// written without branches, is then tested in one loop: with one loop for each pair of clusters,
/// mispredicted ends of the loop cost as much as the tests.
class ClusterPairs {
 public:
  /// `track`: of this filter, or null.
  ClusterPairs(const PosedTree& posed, const SelfFilter& filter, SelfTrack* track, Arena& memory,
               FilteredSink<Contact>& sink, QueryStats& work)
      : posed_(posed),
        masks_(filter.masks),
        track_(track),
        work_(work),
        boxes_(posed, filter.masks.cluster_nodes.data(), memory),
        triangles_(posed.tree, posed.tree, sink, work) {}

  /// Keeps a pointer to the mask until the next test of boxes.
  void add(std::uint32_t low, std::uint32_t high, const PairMask& skipped) {
    const ClusterGridBoxes &boxes_a = boxes_[low], &boxes_b = boxes_[high];
    const unsigned lanes =
        boxes_b.triangles & overlapping(load_boxes(boxes_b), repeat_box(boxes_a));
    const unsigned rows = boxes_a.triangles & overlapping(load_boxes(boxes_a), repeat_box(boxes_b));
    waiting_[count_] = {&boxes_a, &boxes_b, skipped.rows, lanes, low, high};
    rows_.add(count_, rows & ~rows_without(lanes, skipped.rows));
    if (++count_ == kRoom) test_boxes();
  }

  /// With a tracker, measures how far apart the clusters are, or only tests them where that has
  /// gained nothing.
  void add_neighbours(std::uint32_t low, std::uint32_t high, std::uint32_t mask) {
    const PairMask& skipped = masks_.masks.data()[mask];
    if (track_ && track_->may_gain(mask))
      track_->set_slack(
          low, mask,
          test_gaps(cluster(low), cluster(high), skipped.rows, track_->extent, triangles_, work_));
    else
      add(low, high, skipped);
  }

  bool are_apart(std::uint32_t mask) const { return track_ && track_->pair_slack.data()[mask] > 0; }

  void test_boxes();

  void flush() {
    test_boxes();
    triangles_.flush();
  }

 private:
  static constexpr std::uint32_t kRoom = 16;

  struct Waiting {
    const ClusterGridBoxes *boxes_a, *boxes_b;
    const std::uint16_t* skipped;
    unsigned lanes;  // triangles of b near a
    std::uint32_t a, b;
  };

  PosedCluster cluster(std::uint32_t number) const {
    const std::uint32_t n = masks_.cluster_nodes.data()[number];
    const Node& node = posed_.tree.nodes.data()[n];
    return {posed_, node, *posed_.opened[n], number - node.first_cluster};
  }

  /// The rows of which all these lanes are skipped.
  static unsigned rows_without(unsigned lanes, const std::uint16_t* skipped) {
    const Short16 asked(static_cast<std::int16_t>(lanes));
    std::int16_t rows[kMaxClusterTriangles];
    std::memcpy(rows, skipped, sizeof rows);
    return ((load16(rows) & asked) == asked).bits();
  }

  const PosedTree& posed_;
  const PairMasks& masks_;
  SelfTrack* track_;  // or null
  QueryStats& work_;
  GridBoxes boxes_;
  SelfTrianglePairs triangles_;
  Waiting waiting_[kRoom];
  RowLanes rows_;  // number of a waiting pair, triangle of its `a`
  std::uint32_t count_ = 0;
};

inline void ClusterPairs::test_boxes() {
  struct Row {
    std::uint8_t pair, triangle;
    std::uint16_t lanes;
  };
  Row found[kRoom * kMaxClusterTriangles + 1];
  std::uint32_t found_count = 0;
  for (std::uint32_t i = 0; i < rows_.size(); ++i) {
    const unsigned p = rows_.row(i), row = rows_.lane(i);
    const Waiting& pair = waiting_[p];
    const unsigned lanes = pair.lanes & ~unsigned{pair.skipped[row]} &
                           overlapping(load_boxes(*pair.boxes_b), repeat_box(*pair.boxes_a, row));
    found[found_count] = {static_cast<std::uint8_t>(p), static_cast<std::uint8_t>(row),
                          static_cast<std::uint16_t>(lanes)};
    found_count += lanes != 0;
  }
  for (const Row *row = found, *end = found + found_count; row != end;) {
    const Waiting& pair = waiting_[row->pair];
    RowLanes pairs;
    for (const Row* first = row; row != end && row->pair == first->pair; ++row)
      pairs.add(row->triangle, row->lanes);
    triangles_.add(cluster(pair.a), cluster(pair.b), pairs);
  }
  rows_ = RowLanes();
  count_ = 0;
}

/// Waiting pairs of one character. The triangle with the lower number is that of `a`: if several
/// features meet at once, the order of the triangles decides which of them are reported.
class SelfMovingPairs : public WaitingMovingPairs {
 public:
  explicit SelfMovingPairs(const Tree& tree) : WaitingMovingPairs(tree, tree) {}

  Contact contact(unsigned lane) const {
    const Contact pair = WaitingMovingPairs::contact(lane);
    return is_swapped(pair) ? Contact{pair.triangle_b, pair.triangle_a} : pair;
  }

  MovingTriangle triangle_a(unsigned lane) const {
    return is_swapped(lane) ? WaitingMovingPairs::triangle_b(lane)
                            : WaitingMovingPairs::triangle_a(lane);
  }

  MovingTriangle triangle_b(unsigned lane) const {
    return is_swapped(lane) ? WaitingMovingPairs::triangle_a(lane)
                            : WaitingMovingPairs::triangle_b(lane);
  }

 private:
  static bool is_swapped(const Contact& pair) { return pair.triangle_b < pair.triangle_a; }
  bool is_swapped(unsigned lane) const { return is_swapped(WaitingMovingPairs::contact(lane)); }
};

/// Precondition: all nodes are open in both poses.
class MovingClusterPairs {
 public:
  MovingClusterPairs(const MovingTree& moving, const SelfFilter& filter,
                     const MovingOptions& options, FilteredSink<MovingContact>& sink,
                     MovingStats& work)
      : moving_(moving),
        masks_(filter.masks),
        pairs_(moving.tree),
        triangles_(pairs_, sink, options, work) {}

  void add(std::uint32_t low, std::uint32_t high, const PairMask& skipped) {
    pairs_.add(
        cluster(low), cluster(high), OverlapUntil(), [this] { flush(); }, skipped.rows);
  }

  void add_neighbours(std::uint32_t low, std::uint32_t high, std::uint32_t mask) {
    add(low, high, masks_.masks.data()[mask]);
  }

  static constexpr bool are_apart(std::uint32_t) { return false; }
  static void test_boxes() {}

  void flush() { triangles_.flush(); }

 private:
  MovingCluster cluster(std::uint32_t number) const {
    const std::uint32_t n = masks_.cluster_nodes.data()[number];
    const Node& node = moving_.tree.nodes.data()[n];
    return {moving_, node, opened_node(moving_, n), number - node.first_cluster};
  }

  const MovingTree& moving_;
  const PairMasks& masks_;
  SelfMovingPairs pairs_;
  MovingTrianglePairs<SelfMovingPairs, FilteredSink<MovingContact>> triangles_;
};

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail

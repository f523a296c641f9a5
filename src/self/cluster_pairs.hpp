#pragma once

/// Finds the touching triangles of pairs of clusters of one pose. Pairs of clusters wait until
/// there are sixteen. A list of the rows of all of them, which is written without branches, is then
/// tested in one loop: with one loop for each pair of clusters, mispredicted ends of the loop cost
/// as much as the tests.

#include "collide/cluster_pair.hpp"
#include "self/grid_boxes.hpp"

#include <cstring>

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {

class ClusterPairs {
 public:
  ClusterPairs(const PosedTree& posed, const std::uint32_t* cluster_nodes, Arena& memory,
               TrianglePairs& triangles)
      : posed_(posed),
        cluster_nodes_(cluster_nodes),
        boxes_(posed, cluster_nodes, memory),
        triangles_(triangles) {}

  /// Adds the triangles of two clusters, or of a cluster and itself, without the pairs whose bits
  /// are set in `skipped`: bit t of row s for triangle s of `a` and triangle t of `b`. Keeps the
  /// pointer until the next flush.
  void add(std::uint32_t a, std::uint32_t b, const std::uint16_t* skipped) {
    const ClusterGridBoxes &boxes_a = boxes_[a], &boxes_b = boxes_[b];
    const unsigned lanes =
        boxes_b.triangles & overlapping(load_boxes(boxes_b), repeat_box(boxes_a));
    const unsigned rows = boxes_a.triangles & overlapping(load_boxes(boxes_a), repeat_box(boxes_b));
    waiting_[count_] = {&boxes_a, &boxes_b, skipped, lanes, a, b};
    rows_.add(count_, rows & ~rows_without(lanes, skipped));
    if (++count_ == kRoom) flush();
  }

  /// Tests the boxes of the waiting pairs, and hands the triangles over.
  void flush();

  PosedCluster cluster(std::uint32_t number) const {
    const std::uint32_t n = cluster_nodes_[number];
    const Node& node = posed_.tree.nodes.data()[n];
    return {posed_, node, *posed_.opened[n], number - node.first_cluster};
  }

 private:
  static constexpr std::uint32_t kRoom = 16;

  struct Waiting {
    const ClusterGridBoxes *boxes_a, *boxes_b;
    const std::uint16_t* skipped;
    unsigned lanes;  // triangles of b near a
    std::uint32_t a, b;
  };

  /// The rows of which all these lanes are skipped.
  static unsigned rows_without(unsigned lanes, const std::uint16_t* skipped) {
    const Short16 asked(static_cast<std::int16_t>(lanes));
    std::int16_t rows[kMaxClusterTriangles];
    std::memcpy(rows, skipped, sizeof rows);
    return ((load16(rows) & asked) == asked).bits();
  }

  const PosedTree& posed_;
  const std::uint32_t* cluster_nodes_;
  GridBoxes boxes_;
  TrianglePairs& triangles_;
  Waiting waiting_[kRoom];
  RowLanes rows_;  // number of a waiting pair, triangle of its `a`
  std::uint32_t count_ = 0;
};

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail

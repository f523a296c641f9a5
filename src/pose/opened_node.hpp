#pragma once

/// What a query has computed of a node in the current pose: its vertices and the boxes of its
/// slots. Written once for each palette, by whoever needs it first, and then only read.

#include "base/arena.hpp"
#include "model/tree.hpp"

#include <atomic>
#include <cstdint>
#include <memory>

namespace pelt::detail {

/// Boxes of the triangles of a cluster, side by side. Lanes beyond the last triangle repeat it.
struct alignas(32) TriangleBoxes {
  float low[3][kMaxClusterTriangles], high[3][kMaxClusterTriangles];
};

struct alignas(64) OpenedNode {
  float low[3][kMaxSlots], high[3][kMaxSlots];  ///< of the slots; lanes without a slot are empty
  float all_low[4], all_high[4];                ///< the box around them
  const float* positions;                       ///< of the pool, four floats a vertex
  mutable std::atomic<TriangleBoxes*> triangles[kMaxSlots];  ///< of the clusters, once asked for
};

/// The opened nodes of one pose: a table that lies in an arena, as they do, and dies with them.
class OpenedNodes {
 public:
  OpenedNodes() = default;

  /// None of `node_count` nodes is open. Valid until `arena` is cleared.
  OpenedNodes(std::uint32_t node_count, Arena& arena)
      : nodes_(reinterpret_cast<std::atomic<OpenedNode*>*>(
            arena.allocate(node_count * sizeof(std::atomic<OpenedNode*>)))) {
    std::uninitialized_value_construct_n(nodes_, node_count);
  }

  /// Whether there is a table.
  explicit operator bool() const { return nodes_ != nullptr; }

  /// Null if the node has not been opened.
  const OpenedNode* operator[](std::uint32_t node) const {
    return nodes_[node].load(std::memory_order_acquire);
  }

  /// Makes `opened` known, unless another thread was faster; returns the one that counts.
  const OpenedNode* publish(std::uint32_t node, OpenedNode* opened) {
    OpenedNode* first = nullptr;
    const bool was_first = nodes_[node].compare_exchange_strong(
        first, opened, std::memory_order_acq_rel, std::memory_order_acquire);
    return was_first ? opened : first;
  }

 private:
  std::atomic<OpenedNode*>* nodes_ = nullptr;
};

}  // namespace pelt::detail

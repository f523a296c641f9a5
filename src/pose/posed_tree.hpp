#pragma once

/// View of one instance for queries. Queries change an instance only by opening nodes, which poses
/// the node's vertices, computes exact boxes of its clusters from them, and computes the boxes of
/// its children from the joint palette. Doing this only when needed is the refit on demand of Kavan
/// & Zara (2005, section 4.2). If the caller has given all vertices, opening copies nothing, and
/// the boxes of children are known.

#include "base/arena.hpp"
#include "model/node_bounds.hpp"
#include "model/tree.hpp"
#include "pose/pose_boxes.hpp"
#include "skin/palette.hpp"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>

namespace pelt::detail {

/// Boxes of a cluster's triangles in structure-of-arrays order. Lanes beyond the last triangle
/// repeat its box.
struct alignas(32) TriangleBoxes {
  float low[3][kMaxClusterTriangles], high[3][kMaxClusterTriangles];
};

/// An opened node: its posed vertices and the boxes of its slots for the current palette. The first
/// thread that needs the node writes it once per palette; after that it is read-only.
struct alignas(64) OpenedNode {
  /// Boxes of the slots. Lanes without a slot have empty boxes.
  float low[3][kMaxSlots], high[3][kMaxSlots];

  float all_low[4], all_high[4];  ///< box of all slots
  const float* positions;         ///< posed pool, four floats per vertex

  /// Boxes of the triangles of each cluster; null until needed.
  mutable std::atomic<TriangleBoxes*> triangles[kMaxSlots];
};

/// Table of the opened nodes of one pose. Table and nodes live in the same arena.
class OpenedNodes {
 public:
  OpenedNodes() = default;

  /// A table of `node_count` closed nodes. Valid until `arena` is cleared.
  OpenedNodes(std::uint32_t node_count, Arena& arena)
      : nodes_(reinterpret_cast<std::atomic<OpenedNode*>*>(
            arena.allocate(node_count * sizeof(std::atomic<OpenedNode*>)))) {
    std::uninitialized_value_construct_n(nodes_, node_count);
  }

  /// Whether the table exists.
  explicit operator bool() const { return nodes_ != nullptr; }

  /// Returns the opened node, or null if the node is closed.
  const OpenedNode* operator[](std::uint32_t node) const {
    return nodes_[node].load(std::memory_order_acquire);
  }

  /// Publishes `opened`, unless another thread has published the node first. Returns the published
  /// one.
  const OpenedNode* publish(std::uint32_t node, OpenedNode* opened) {
    OpenedNode* first = nullptr;
    const bool was_first = nodes_[node].compare_exchange_strong(
        first, opened, std::memory_order_acq_rel, std::memory_order_acquire);
    return was_first ? opened : first;
  }

 private:
  std::atomic<OpenedNode*>* nodes_ = nullptr;
};

struct PosedTree {
  const Tree& tree;
  const NodeBounds& bounds;
  const Palette& palette;
  const GivenVertices& given;  ///< if any, the palette has no meaning
  RootBox& root_box;           ///< unlike nodes, must not be used by two threads at once
  OpenedNodes& opened;
  Arena& arena;  ///< memory for the nodes that this thread opens
};

/// Creates the table of opened nodes if necessary. Instances that are far from all others never
/// need it. Must not be called by two threads at once.
void make_table(const PosedTree& posed);

/// Bytes of arena memory for the table and all nodes, if one thread opens everything.
std::size_t bytes_to_open(const Tree& tree);

}  // namespace pelt::detail

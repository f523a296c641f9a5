#pragma once

/// A part of a posed tree: the whole tree, or a slot of an opened node.

#include "pose/open_node.hpp"
#include "query/slots.hpp"

#include <cstdint>

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {

struct TreePart {
  std::uint32_t node = 0;  ///< opened, unless the part is the whole tree
  std::uint32_t slot = kWhole;

  static constexpr std::uint32_t kWhole = kMaxSlots;
};

inline bool is_cluster(const PosedTree& posed, const TreePart& part) {
  return part.slot < posed.tree.nodes[part.node].cluster_count;
}

/// Returns the node of the part. Precondition: the part is not a cluster.
inline std::uint32_t node_of(const PosedTree& posed, const TreePart& part) {
  return part.slot == TreePart::kWhole ? 0 : child(posed.tree.nodes[part.node], part.slot);
}

/// Precondition: the part is a cluster.
inline PosedCluster cluster_of(const PosedTree& posed, const TreePart& part) {
  return {posed, posed.tree.nodes[part.node], *posed.opened[part.node], part.slot};
}

/// Returns the smallest known box around the part, opened or not.
inline Box8 known_box(const PosedTree& posed, const TreePart& part) {
  if (!is_cluster(posed, part)) {
    if (const OpenedNode* opened = posed.opened[node_of(posed, part)])
      return point_box(opened->all_low, opened->all_high);
    if (part.slot == TreePart::kWhole) return point_box(posed.root_box.low, posed.root_box.high);
  }
  const OpenedNode& parent = *posed.opened[part.node];
  return lane_box(parent.low, parent.high, part.slot);
}

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail

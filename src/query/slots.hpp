#pragma once

/// Slots of an opened node as bit sets.

#include "pose/posed_tree.hpp"
#include "query/lanes.hpp"

#include <cstdint>

namespace pelt::detail {

/// One cluster of an opened node.
struct PosedCluster {
  const PosedTree& posed;
  const Node& node;
  const OpenedNode& opened;
  std::uint32_t slot;

  const Cluster& cluster() const { return posed.tree.clusters[node.first_cluster + slot]; }
};

inline namespace PELT_INSTRUCTION_SET {

inline constexpr unsigned kAllSlots = (1u << kMaxSlots) - 1;

/// The slots in use, one bit each.
inline unsigned slots_of(const Node& node) {
  return (1u << (node.cluster_count + node.child_count)) - 1;
}

/// The slots that are clusters.
inline unsigned clusters_of(const Node& node) { return (1u << node.cluster_count) - 1; }

/// Index of the child node in `slot`. Precondition: the slot does not hold a cluster.
inline std::uint32_t child(const Node& node, unsigned slot) {
  return node.first_child + slot - node.cluster_count;
}

/// The slots whose boxes overlap `box`.
inline unsigned slots_in(const OpenedNode& opened, const Box8& box) {
  return overlapping(opened.low, opened.high, 0, box);
}

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail

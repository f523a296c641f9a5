#pragma once

/// Collapses the binary tree into nodes of at most eight slots at the least cost, by dynamic
/// programming (Ylitie, Karras & Laine 2017, "Efficient incoherent ray traversal on GPUs through
/// compressed wide BVHs", section 3.1). The frequency with which a node is opened is about
/// proportional to its area. Opening a node has a fixed cost and a cost per slot; a cluster costs
/// no more than its slot.

#include "model/clusters.hpp"
#include "model/tree.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace pelt::detail {

/// The fixed cost of opening a node, in slots.
inline constexpr double kNodeCost = 8;

/// A node with its slots, given as nodes of the cluster tree: first its clusters, then the nodes
/// that become its children, which are numbered consecutively from `first_child`.
struct WideNode {
  std::array<std::uint32_t, kMaxSlots> slots = {};
  std::uint32_t first_child = 0;
  std::uint8_t cluster_count = 0, child_count = 0;
};

/// Returns the nodes breadth first; node 0 is the root.
std::vector<WideNode> collapse(const ClusterTree& tree);

}  // namespace pelt::detail

#pragma once

/// The binary tree collapsed into nodes of at most eight slots, at the least cost by dynamic
/// programming (Ylitie, Karras & Laine 2017, "Efficient incoherent ray traversal on GPUs through
/// compressed wide BVHs", section 3.1). A node is opened about as often as its area is large, and
/// opening it costs some fixed work and some for each slot; clusters cost nothing more than their
/// slots.

#include "model/clusters.hpp"
#include "model/tree.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace pelt::detail {

/// The fixed cost of opening a node, in slots.
inline constexpr double kNodeCost = 8;

/// Its slots name nodes of the cluster tree: first its clusters, then those whose wide nodes are
/// its children, numbered consecutively from `first_child`.
struct WideNode {
  std::array<std::uint32_t, kMaxSlots> slots = {};
  std::uint32_t first_child = 0;
  std::uint8_t cluster_count = 0, child_count = 0;
};

/// Breadth first; node 0 is the root.
std::vector<WideNode> collapse(const ClusterTree& tree);

}  // namespace pelt::detail

#pragma once

#include "model/tree.hpp"

#include <cstdint>

namespace pelt::detail {

inline constexpr std::uint32_t kNoTriangle = UINT32_MAX;

/// Computes Tree::triangles_below, and Tree::lowest_below with kNoTriangle in slots that are not in
/// use. Precondition: parents precede their children.
void index_triangles_below(Tree& tree);

/// Number of triangles below a slot: those of a cluster, or those of a child and all nodes below
/// it. Precondition: the slot is in use.
inline std::uint32_t triangles_below(const Tree& tree, const Node& node, unsigned slot) {
  return slot < node.cluster_count
             ? tree.clusters[node.first_cluster + slot].triangle_count
             : tree.triangles_below[node.first_child + slot - node.cluster_count];
}

}  // namespace pelt::detail

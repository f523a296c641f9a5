#pragma once

#include "model/tree.hpp"

namespace pelt::detail {

/// Computes Tree::triangles_below from the clusters and nodes. Precondition: parents precede their
/// children.
void count_triangles_below(Tree& tree);

/// Number of triangles below a slot: those of a cluster, or those of a child and all nodes below
/// it. Precondition: the slot is in use.
inline std::uint32_t triangles_below(const Tree& tree, const Node& node, unsigned slot) {
  return slot < node.cluster_count
             ? tree.clusters[node.first_cluster + slot].triangle_count
             : tree.triangles_below[node.first_child + slot - node.cluster_count];
}

}  // namespace pelt::detail

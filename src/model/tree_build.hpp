#pragma once

/// Builds the tree of a model.

#include "model/clusters.hpp"
#include "model/tree.hpp"
#include "skin/skinned_mesh.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace pelt::detail {

/// Builds a tree that is optimised for poses like the samples. A sample has the posed positions [V]
/// of all vertices; the first sample is the rest pose. Bit-identical vertices are merged if the
/// mesh may weld and they have no offsets; the tree stores for each vertex of the mesh a vertex
/// that is posed to the same bits. The tree is the same on every machine.
///
/// Nodes are numbered breadth first. The clusters, children and pool of a node follow those of the
/// previous node, and the triangles and vertices of a cluster those of the previous cluster. A pool
/// is sorted by number of influences, so that a loop over its vertices seldom changes its length.
///
/// Precondition: at least one sample, and finite positions. O((T + V) log(T + V)).
Tree build_tree(const SkinnedMesh& mesh, std::span<const std::vector<Vec3>> samples);

// Collapses the binary tree into nodes of at most eight slots at the least cost, by dynamic
// programming (Ylitie, Karras & Laine 2017, "Efficient incoherent ray traversal on GPUs through
// compressed wide BVHs", section 3.1). The frequency with which a node is opened is about
// proportional to its area. Opening a node has a fixed cost and a cost per slot; a cluster costs
// no more than its slot.

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

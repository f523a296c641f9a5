#pragma once

/// Groups triangles into clusters: a binary tree, built top-down with the surface area heuristic
/// (MacDonald & Booth 1990, "Heuristics for ray tracing using space subdivision") over bins (Wald
/// 2007, "On fast construction of SAH-based bounding volume hierarchies").
///
/// The cost of a cluster does not depend on the number of its triangles, because all 16 lanes are
/// tested at once. A set of n triangles therefore counts as ceil(n / 16) clusters, which favours
/// cuts that fill clusters. The area of a set is the mean over the sample poses, so that triangles
/// which stay together in motion end up in the same cluster.

#include "model/sample_boxes.hpp"

#include <cstdint>
#include <vector>

namespace pelt::detail {

/// Parents before children; node 0 is the root.
struct ClusterTreeNode {
  std::uint32_t first = 0;       ///< into ClusterTree::triangle_order
  std::uint32_t count = 0;       ///< triangles
  std::uint32_t left_child = 0;  ///< the right child follows it; 0: this is a cluster
  double area = 0;               ///< half the surface of its box, mean over the sample poses

  bool is_cluster() const { return left_child == 0; }
};

struct ClusterTree {
  std::vector<std::uint32_t> triangle_order;  // [T]
  std::vector<ClusterTreeNode> nodes;
};

/// Largest number of nodes on any path from the root to a cluster.
inline constexpr std::uint32_t kMaxClusterTreeDepth = 96;

/// Builds the tree, which is the same on every machine. Precondition: there is at least one
/// triangle. O(S^2 T log T) for S samples.
ClusterTree build_cluster_tree(const SampleBoxes& boxes);

}  // namespace pelt::detail

#pragma once

/// Triangles to clusters: a binary tree, cut from the top down by the surface area heuristic
/// (MacDonald & Booth 1990, "Heuristics for ray tracing using space subdivision") over bins (Wald
/// 2007, "On fast construction of SAH-based bounding volume hierarchies").
///
/// What a cluster costs does not depend on how full it is: opening one tests all of its places side
/// by side. So a set of n triangles counts as ceil(n / 16) clusters, and cuts that fill clusters
/// win. The area of a set is its mean over the sample poses, so that triangles are kept together
/// that stay together in motion.

#include "model/sample_boxes.hpp"

#include <cstdint>
#include <vector>

namespace pelt::detail {

/// Parents before children; node 0 is the root.
struct ClusterTreeNode {
  std::uint32_t first = 0;       ///< into ClusterTree::triangle_order
  std::uint32_t count = 0;       ///< triangles
  std::uint32_t left_child = 0;  ///< the right one follows it; 0: a cluster
  double area = 0;               ///< half the surface of its box, mean over the sample poses

  bool is_cluster() const { return left_child == 0; }
};

struct ClusterTree {
  std::vector<std::uint32_t> triangle_order;  // [T]
  std::vector<ClusterTreeNode> nodes;
};

/// No path from the root to a cluster has more nodes, whatever the triangles.
inline constexpr std::uint32_t kMaxClusterTreeDepth = 96;

/// Precondition: there is at least one triangle. O(S^2 T log T) for S samples; the same tree on
/// every machine.
ClusterTree build_cluster_tree(const SampleBoxes& boxes);

}  // namespace pelt::detail

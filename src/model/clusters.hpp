#pragma once

/// Groups triangles into clusters: a binary tree, built top-down with the surface area heuristic
/// (MacDonald & Booth 1990, "Heuristics for ray tracing using space subdivision") over bins (Wald
/// 2007, "On fast construction of SAH-based bounding volume hierarchies").
///
/// The cost of a cluster does not depend on the number of its triangles, because all 16 lanes are
/// tested at once. A set of n triangles therefore counts as ceil(n / 16) clusters, which favours
/// cuts that fill clusters. The area of a set is the mean over the sample poses, so that triangles
/// which stay together in motion end up in the same cluster.

#include <pelt/mesh.hpp>

#include "geometry/box4.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace pelt::detail {

/// The boxes of all triangles in all sample poses.
class SampleBoxes {
 public:
  /// `samples`: posed positions of all vertices in each pose. Precondition: at least one pose, and
  /// all positions are finite.
  SampleBoxes(std::span<const Triangle> triangles, std::span<const std::vector<Vec3>> samples);

  std::uint32_t triangle_count() const { return triangle_count_; }
  std::uint32_t sample_count() const { return sample_count_; }

  /// One box for each sample pose.
  const Box4* of(std::uint32_t triangle) const {
    return boxes_.data() + std::size_t{triangle} * sample_count_;
  }

 private:
  std::uint32_t triangle_count_, sample_count_;
  std::vector<Box4> boxes_;  // [T][S]
};

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

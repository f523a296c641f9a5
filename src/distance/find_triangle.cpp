#include "distance/find_triangle.hpp"

#include "base/assert.hpp"
#include "pose/open_node.hpp"

#include <algorithm>

namespace pelt::detail {
namespace {

/// The cluster that has the triangle at `place`. Clusters lie in the order of their triangles.
std::uint32_t cluster_with(const Tree& tree, std::uint32_t place) {
  const auto behind = std::upper_bound(
      tree.clusters.begin(), tree.clusters.end(), place,
      [](std::uint32_t p, const Cluster& cluster) { return p < cluster.first_triangle; });
  return static_cast<std::uint32_t>(behind - tree.clusters.begin()) - 1;
}

/// The node that has a cluster: not found by its first one, which a node without clusters has too.
std::uint32_t node_with(const Tree& tree, std::uint32_t cluster) {
  const auto node = std::find_if(tree.nodes.begin(), tree.nodes.end(), [=](const Node& n) {
    return cluster - n.first_cluster < n.cluster_count;
  });
  PELT_ASSERT(node != tree.nodes.end());
  return static_cast<std::uint32_t>(node - tree.nodes.begin());
}

}  // namespace

FoundTriangle find_triangle(const PosedTree& posed, std::uint32_t id) {
  const Tree& tree = posed.tree;
  const auto number = std::find(tree.triangle_ids.begin(), tree.triangle_ids.end(), id);
  PELT_ASSERT(number != tree.triangle_ids.end());
  const auto place = static_cast<std::uint32_t>(number - tree.triangle_ids.begin());
  const std::uint32_t cluster = cluster_with(tree, place), node = node_with(tree, cluster);
  QueryStats work;
  const OpenedNode& opened = open_node(posed, node, work);
  FoundTriangle found = {{}, node, cluster - tree.nodes[node].first_cluster};
  for (std::size_t k = 0; k < 3; ++k) {
    const float* p = opened.positions + tree.corners[place][k];
    found.corners[k] = {p[0], p[1], p[2]};
  }
  return found;
}

}  // namespace pelt::detail

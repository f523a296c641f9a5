#include "model/triangles_below.hpp"

#include <algorithm>

namespace pelt::detail {
namespace {

std::uint32_t lowest_below(const Tree& tree, const Node& node, unsigned slot) {
  if (slot >= node.cluster_count) {
    const auto& below = tree.lowest_below[node.first_child + slot - node.cluster_count];
    return *std::min_element(below.begin(), below.end());
  }
  const Cluster& cluster = tree.clusters[node.first_cluster + slot];
  const auto first = tree.triangle_ids.begin() + cluster.first_triangle;
  return *std::min_element(first, first + cluster.triangle_count);
}

}  // namespace

void index_triangles_below(Tree& tree) {
  tree.triangles_below.assign(tree.nodes.size(), 0);
  tree.lowest_below.resize(tree.nodes.size());
  for (std::size_t n = tree.nodes.size(); n-- > 0;) {
    const Node& node = tree.nodes[n];
    tree.lowest_below[n].fill(kNoTriangle);
    for (unsigned slot = 0; slot < unsigned{node.cluster_count} + node.child_count; ++slot) {
      tree.triangles_below[n] += triangles_below(tree, node, slot);
      tree.lowest_below[n][slot] = lowest_below(tree, node, slot);
    }
  }
}

}  // namespace pelt::detail

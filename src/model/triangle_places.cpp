#include "model/triangle_places.hpp"

#include "base/assert.hpp"

#include <algorithm>

namespace pelt::detail {

void index_triangles(Tree& tree) {
  tree.triangle_places.resize(tree.triangle_count());
  for (std::uint32_t place = 0; place < tree.triangle_count(); ++place)
    tree.triangle_places[tree.triangle_ids[place]] = place;
}

/// Clusters, and therefore their triangles, are numbered node by node. Of nodes with the same first
/// cluster, only the last has clusters.
std::uint32_t node_of_triangle(const Tree& tree, std::uint32_t place) {
  PELT_ASSERT(place < tree.triangle_count());
  const auto begins_after = [&](std::uint32_t triangle, const Node& node) {
    return node.first_cluster == tree.clusters.size() ||
           triangle < tree.clusters[node.first_cluster].first_triangle;
  };
  const auto next = std::upper_bound(tree.nodes.begin(), tree.nodes.end(), place, begins_after);
  return static_cast<std::uint32_t>(next - tree.nodes.begin()) - 1;
}

std::uint32_t slot_of_triangle(const Tree& tree, const Node& node, std::uint32_t place) {
  std::uint32_t slot = 0;
  while (slot + 1 < node.cluster_count &&
         tree.clusters[node.first_cluster + slot + 1].first_triangle <= place)
    ++slot;
  return slot;
}

Places places_of(const Tree& tree, const Node& node) {
  if (node.cluster_count == 0) return {};
  const Cluster* clusters = tree.clusters.data() + node.first_cluster;
  const Cluster& last = clusters[node.cluster_count - 1];
  return {clusters[0].first_triangle, last.first_triangle + last.triangle_count};
}

}  // namespace pelt::detail

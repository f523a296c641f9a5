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

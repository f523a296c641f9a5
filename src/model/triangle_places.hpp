#pragma once

/// Locates triangles in the tree. The place of a triangle is its index into Tree::corners; the
/// place of the caller's triangle `id` is Tree::triangle_places[id].

#include "model/tree.hpp"

#include <cstdint>

namespace pelt::detail {

/// Computes Tree::triangle_places from Tree::triangle_ids. Precondition: the ids are a permutation.
void index_triangles(Tree& tree);

/// The node whose pool has the corners of the triangle at `place`. Cost: O(log N).
std::uint32_t node_of_triangle(const Tree& tree, std::uint32_t place);

/// The slot of `node` whose cluster has the triangle at `place`. Precondition: the slot exists.
std::uint32_t slot_of_triangle(const Tree& tree, const Node& node, std::uint32_t place);

/// A range of places.
struct Places {
  std::uint32_t first = 0, end = 0;
};

/// The places of the triangles in the clusters of a node.
Places places_of(const Tree& tree, const Node& node);

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

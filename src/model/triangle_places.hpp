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

}  // namespace pelt::detail

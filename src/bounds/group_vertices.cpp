#include "bounds/group_vertices.hpp"

#include <pelt/vertex_groups.hpp>

#include "model/unpack.hpp"

#include <algorithm>

namespace pelt::detail {
namespace {

/// Calls `visit(triangle, place)` for each corner of each triangle. A vertex in several pools has
/// the same place in all triangles.
template <typename Visit>
void each_corner(const Tree& tree, const Visit& visit) {
  const SkinnedMesh mesh = unpack_mesh(tree);
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
    for (const std::uint32_t vertex : mesh.triangles[t]) visit(t, tree.vertex_places[vertex]);
}

std::uint32_t leading_joint(const Tree& tree, std::uint32_t place) {
  const auto weights = tree.weights.begin();
  const auto first = weights + tree.influence_begin[place];
  const auto last = weights + tree.influence_begin[place + 1];
  return tree.joints[static_cast<std::size_t>(std::max_element(first, last) - weights)];
}

void keep_each_once(VertexSets& sets) {
  for (std::vector<std::uint32_t>& places : sets) {
    std::sort(places.begin(), places.end());
    places.erase(std::unique(places.begin(), places.end()), places.end());
  }
}

}  // namespace

VertexSets corners_by_label(const Tree& tree, std::span<const std::uint32_t> labels,
                            std::uint32_t count) {
  VertexSets sets(count);
  each_corner(tree, [&](std::uint32_t triangle, std::uint32_t place) {
    if (labels[triangle] != kNoGroup) sets[labels[triangle]].push_back(place);
  });
  keep_each_once(sets);
  return sets;
}

VertexSets corners_by_joint(const Tree& tree) {
  VertexSets sets(tree.joint_count);
  each_corner(tree, [&](std::uint32_t, std::uint32_t place) {
    sets[leading_joint(tree, place)].push_back(place);
  });
  keep_each_once(sets);
  return sets;
}

}  // namespace pelt::detail

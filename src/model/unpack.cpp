#include "model/unpack.hpp"

namespace pelt::detail {
namespace {

void append_vertex(const SkinnedMesh& from, std::uint32_t v, SkinnedMesh& to) {
  to.rest_positions.push_back(from.rest_positions[v]);
  const auto influences = from.influences_of(v);
  to.influences.insert(to.influences.end(), influences.begin(), influences.end());
  to.influence_begin.push_back(static_cast<std::uint32_t>(to.influences.size()));
  if (!from.offset_caps.empty()) to.offset_caps.push_back(from.offset_caps[v]);
  if (from.morph_extents.empty()) return;
  const auto displacements = from.displacements_of(v);
  to.displacements.insert(to.displacements.end(), displacements.begin(), displacements.end());
  to.displacement_begin.push_back(static_cast<std::uint32_t>(to.displacements.size()));
}

/// Sorts displacements by vertex instead of by node and target: one pass counts, one moves.
void unpack_displacements(const PoolMorphs& morphs, SkinnedMesh& mesh) {
  mesh.morph_extents = morphs.extents;
  if (morphs.extents.empty()) return;
  auto& begin = mesh.displacement_begin;
  begin.assign(mesh.rest_positions.size() + 1, 0);
  for (const PlacedDisplacement& displacement : morphs.displacements)
    ++begin[displacement.place + 1];
  for (std::size_t p = 1; p < begin.size(); ++p) begin[p] += begin[p - 1];
  mesh.displacements.resize(begin.back());
  std::vector<std::uint32_t> next(begin.begin(), begin.end() - 1);
  for (const PoolTarget& run : morphs.targets)
    for (std::uint32_t i = 0; i < run.displacement_count; ++i) {
      const PlacedDisplacement& displacement = morphs.displacements[run.first_displacement + i];
      mesh.displacements[next[displacement.place]++] = {run.target, displacement.by};
    }
}

/// Writes the triangles of one cluster with the caller's vertex numbers.
void unpack_cluster(const Tree& tree, const Node& node, const Cluster& cluster,
                    std::vector<Triangle>& triangles) {
  const std::uint32_t end = cluster.first_triangle + cluster.triangle_count;
  for (std::uint32_t t = cluster.first_triangle; t < end; ++t)
    for (std::size_t k = 0; k < 3; ++k)
      triangles[tree.triangle_ids[t]][k] =
          tree.place_vertices[node.first_vertex + tree.corners[t][k] / kFloatsPerVertex];
}

}  // namespace

SkinnedMesh unpack_vertices(const Tree& tree) {
  SkinnedMesh mesh;
  mesh.rest_positions = tree.rest_positions;
  mesh.influence_begin = tree.influence_begin;
  mesh.influences.reserve(tree.joints.size());
  for (std::size_t i = 0; i < tree.joints.size(); ++i)
    mesh.influences.push_back({tree.joints[i], tree.weights[i]});
  mesh.joint_count = tree.joint_count;
  mesh.rest_extent = tree.rest_extent;
  mesh.dual_influences = tree.dual_influences;
  unpack_displacements(tree.morphs, mesh);
  mesh.offset_caps = tree.offset_caps;
  return mesh;
}

SkinnedMesh unpack_mesh(const Tree& tree) {
  const SkinnedMesh vertices = unpack_vertices(tree);
  SkinnedMesh mesh;
  mesh.joint_count = tree.joint_count;
  mesh.rest_extent = tree.rest_extent;
  mesh.dual_influences = tree.dual_influences;
  mesh.influence_begin.push_back(0);
  mesh.morph_extents = tree.morphs.extents;
  if (!mesh.morph_extents.empty()) mesh.displacement_begin.push_back(0);
  for (const std::uint32_t place : tree.vertex_places) append_vertex(vertices, place, mesh);

  mesh.triangles.resize(tree.triangle_count());
  for (const Node& node : tree.nodes)
    for (std::uint32_t c = 0; c < node.cluster_count; ++c)
      unpack_cluster(tree, node, tree.clusters[node.first_cluster + c], mesh.triangles);
  return mesh;
}

}  // namespace pelt::detail

#pragma once

/// The tree behind every query, in flat arrays that can be written to a file as they are.
///
/// Triangles lie in clusters of at most 16, clusters and nodes in nodes of at most eight slots. The
/// first slots of a node are its clusters, the others its child nodes; both are numbered
/// consecutively. All clusters of a node take their corners from the node's pool of vertices, in
/// which no two are alike, so that opening a node poses each of its vertices once. Parents come
/// before their children; node 0 is the root.

#include "model/pool_morphs.hpp"
#include "skin/palette.hpp"

#include <pelt/math.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace pelt::detail {

inline constexpr std::uint32_t kMaxClusterTriangles = 16;
inline constexpr std::uint32_t kMaxSlots = 8;

/// A posed vertex takes so many floats. Corners are offsets in floats, not numbers of vertices: the
/// loops over them then need no multiplication.
inline constexpr std::uint32_t kFloatsPerVertex = 4;

/// Lists of a cluster's vertices are filled up to a multiple of this.
inline constexpr std::uint32_t kVertexGroup = 4;

struct Cluster {
  std::uint32_t first_triangle = 0;  ///< into Tree::corners and Tree::triangle_ids
  std::uint32_t first_vertex = 0;    ///< into Tree::cluster_vertices
  std::uint8_t triangle_count = 0;   ///< 1 to kMaxClusterTriangles
  std::uint8_t vertex_count = 0;     ///< different corners of these triangles
  std::uint16_t unused = 0;          ///< so that every byte of a file has a value

  /// With those that fill the list up.
  std::uint32_t listed_vertex_count() const {
    return (vertex_count + kVertexGroup - 1) / kVertexGroup * kVertexGroup;
  }
};

struct Node {
  std::uint32_t first_vertex = 0;   ///< of the pool, into Tree::rest_positions
  std::uint32_t first_cluster = 0;  ///< slots [0, cluster_count)
  std::uint32_t first_child = 0;    ///< slots [cluster_count, cluster_count + child_count)
  std::uint16_t vertex_count = 0;   ///< of the pool
  std::uint8_t cluster_count = 0;
  std::uint8_t child_count = 0;
};

struct Tree {
  // The vertices [P] of all pools, node after node; after them those that no triangle uses.
  std::vector<Vec3> rest_positions;            // [P]
  std::vector<std::uint32_t> influence_begin;  // [P + 1], into joints and weights
  std::vector<std::uint16_t> joints;           // of the influences, ascending in each vertex
  std::vector<float> weights;                  // of the influences, positive

  // Triangles [T] in the order of the clusters.
  std::vector<std::array<std::uint16_t, 3>> corners;  // [T] offsets in the posed pool
  std::vector<std::uint32_t> triangle_ids;            // [T] the caller's number

  // The corners of each cluster, each offset once and the last one again until the list is full:
  // loops over it then take few different numbers of steps, which branches predict.
  std::vector<std::uint16_t> cluster_vertices;

  std::vector<Cluster> clusters;
  std::vector<Node> nodes;

  std::vector<std::uint32_t> vertex_places;  // [V] where each of the caller's vertices lies in [P]

  PoolMorphs morphs;

  std::uint32_t joint_count = 0;
  float rest_extent = 0;  // as in SkinnedMesh

  std::uint32_t vertex_count() const { return static_cast<std::uint32_t>(vertex_places.size()); }
  std::uint32_t triangle_count() const { return static_cast<std::uint32_t>(triangle_ids.size()); }
};

/// Of an instance in the rest pose.
inline Palette rest_palette(const Tree& tree) {
  return Palette(tree.joint_count, tree.rest_extent, tree.morphs.extents);
}

}  // namespace pelt::detail

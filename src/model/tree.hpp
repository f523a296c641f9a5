#pragma once

/// The tree behind every query, in flat arrays that can be written to a file unchanged.
///
/// Triangles are grouped into clusters of at most 16, and clusters into nodes of at most eight
/// slots. The first slots of a node are its clusters, the other slots its child nodes; clusters and
/// children of a node are numbered consecutively. The corners of a node's clusters refer to the
/// node's pool of distinct vertices, so opening a node poses each of its vertices once. Parents
/// precede their children; node 0 is the root.
///
///     node 0    | cluster 0 | cluster 1 | child 1 | child 2 |          slots
///     node 1    | cluster 2 | cluster 3 |
///     node 2    | cluster 4 | child 3 |
///
///     vertices  | pool of 0      | pool of 1  | pool of 2  | ... | vertices without triangles |

#include <pelt/math.hpp>

#include "base/instruction_set.hpp"
#include "skin/palette.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace pelt::detail {

/// One target's displacements in one pool.
struct PoolTarget {
  std::uint32_t target = 0;
  std::uint32_t first_displacement = 0;  ///< into PoolMorphs::displacements
  std::uint32_t displacement_count = 0;  ///< at least one
};

/// Displacement of the vertex at `place` in Tree::rest_positions.
struct PlacedDisplacement {
  Vec3 by;  ///< not zero
  std::uint32_t place = 0;
};

/// Displacements of the vertices of a tree's pools, sorted by node and then by target. Opening a
/// node therefore costs nothing for targets that are inactive or displace no vertex of its pool.
struct PoolMorphs {
  std::vector<float> extents;             // [M] as in SkinnedMesh
  std::vector<std::uint32_t> node_begin;  // [N + 2] into targets; the last "node" has the vertices
                                          // that no triangle uses; empty if M is 0
  std::vector<PoolTarget> targets;        // ascending in each node
  std::vector<PlacedDisplacement> displacements;  // places ascending in each of these

  std::uint32_t target_count() const { return static_cast<std::uint32_t>(extents.size()); }
};

inline namespace PELT_INSTRUCTION_SET {

/// Calls `visit(item)` for each item with an active target. Precondition: the items ascend by
/// `target`. Cost: one step per item, or a few per active target, whichever is less.
template <typename Item, typename Visit>
inline void each_active(const Item* begin, const Item* end, const MorphWeights& morphs,
                        const Visit& visit) {
  const std::span<const std::uint32_t> active = morphs.active();
  if (static_cast<std::size_t>(end - begin) <= 8 * active.size()) {
    for (; begin != end; ++begin)
      if (morphs[begin->target] != 0) visit(*begin);
    return;
  }
  for (const std::uint32_t target : active) {
    for (std::ptrdiff_t count = end - begin; count > 0;) {  // find the first item that is not less
      const std::ptrdiff_t half = count / 2;
      const bool is_less = begin[half].target < target;
      begin += is_less ? half + 1 : 0;
      count = is_less ? count - half - 1 : half;
    }
    if (begin == end) return;
    if (begin->target == target) visit(*begin);
  }
}

}  // namespace PELT_INSTRUCTION_SET

inline constexpr std::uint32_t kMaxClusterTriangles = 16;
inline constexpr std::uint32_t kMaxSlots = 8;

/// Number of floats of a posed vertex. Corners are offsets in floats and not vertex numbers, so
/// loops over corners need no multiplication.
inline constexpr std::uint32_t kFloatsPerVertex = 4;

/// Lists of a cluster's vertices are padded to a multiple of this.
inline constexpr std::uint32_t kVertexPadding = 4;

struct Cluster {
  std::uint32_t first_triangle = 0;  ///< into Tree::corners and Tree::triangle_ids
  std::uint32_t first_vertex = 0;    ///< into Tree::cluster_vertices
  std::uint8_t triangle_count = 0;   ///< 1 to kMaxClusterTriangles
  std::uint8_t vertex_count = 0;     ///< distinct vertices of these triangles
  std::uint16_t unused = 0;          ///< padding, so that every byte of a file is defined

  /// Number of vertices including padding.
  std::uint32_t listed_vertex_count() const {
    return (vertex_count + kVertexPadding - 1) / kVertexPadding * kVertexPadding;
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

/// A vertex of the caller that was merged with a lower one.
struct WeldedVertex {
  std::uint32_t vertex = 0, into = 0;
};

struct Tree {
  // Vertices [P] of all pools in the order of the nodes, then the vertices without triangles.
  std::vector<Vec3> rest_positions;            // [P]
  std::vector<std::uint32_t> influence_begin;  // [P + 1], into joints and weights
  std::vector<std::uint16_t> joints;           // of the influences; order as in SkinnedMesh
  std::vector<float> weights;                  // of the influences, positive

  // Triangles [T] in the order of the clusters.
  std::vector<std::array<std::uint16_t, 3>> corners;  // [T] offsets into the posed pool
  std::vector<std::uint32_t> triangle_ids;            // [T] the caller's numbers
  std::vector<std::uint32_t> triangle_places;         // [T] the inverse; not in prepared files

  // The distinct corners of each cluster, padded with the last one: loops over the list then have
  // few different lengths, which branches predict well.
  std::vector<std::uint16_t> cluster_vertices;

  std::vector<Cluster> clusters;
  std::vector<Node> nodes;

  // The triangles below each node, and below each slot. Not in prepared files.
  std::vector<std::uint32_t> triangles_below;                      // [N] how many
  std::vector<std::array<std::uint32_t, kMaxSlots>> lowest_below;  // [N] the lowest triangle_ids

  std::vector<std::uint32_t> vertex_places;  // [V] position in [P] of each of the caller's vertices
  std::vector<std::uint32_t> place_vertices;  // [P] the caller's vertex; the lowest of welded ones
  std::vector<float> offset_caps;             // [P] or empty, as in SkinnedMesh
  std::vector<WeldedVertex> welded_vertices;  // ascending; not in prepared files

  PoolMorphs morphs;

  std::vector<JointLink> links;  // ascending; empty with linear blend skinning

  std::uint32_t joint_count = 0;
  float rest_extent = 0;              // as in SkinnedMesh
  std::uint32_t dual_influences = 0;  // as in SkinnedMesh

  std::uint32_t vertex_count() const { return static_cast<std::uint32_t>(vertex_places.size()); }
  std::uint32_t triangle_count() const { return static_cast<std::uint32_t>(triangle_ids.size()); }
};

/// The palette of an instance in the rest pose.
inline Palette rest_palette(const Tree& tree) {
  return Palette(tree.joint_count, tree.rest_extent, tree.morphs.extents, tree.dual_influences,
                 tree.links);
}

}  // namespace pelt::detail

#pragma once

#include "model/tree.hpp"
#include "skin/skinned_mesh.hpp"

#include <span>
#include <vector>

namespace pelt::detail {

/// Builds the tree for poses like the samples, which are the posed positions [V] of all vertices;
/// the first is the rest pose. Vertices that are bit-identical become one, so their numbers are not
/// kept, but for each vertex of the mesh the tree knows one that is posed to the same bits.
///
/// Nodes are numbered breadth first; a node's clusters, children and pool, a cluster's triangles
/// and vertices follow those of the node or cluster before it. In a pool, vertices with few
/// influences come first, so that a loop over them seldom changes its length.
///
/// Precondition: one sample at least, finite. O((T + V) log(T + V)); the same tree on every
/// machine.
Tree build_tree(const SkinnedMesh& mesh, std::span<const std::vector<Vec3>> samples);

}  // namespace pelt::detail

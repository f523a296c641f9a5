#pragma once

#include "model/tree.hpp"
#include "skin/skinned_mesh.hpp"

#include <span>
#include <vector>

namespace pelt::detail {

/// Builds a tree that is optimised for poses like the samples. A sample has the posed positions [V]
/// of all vertices; the first sample is the rest pose. Bit-identical vertices are merged if the
/// mesh may weld and they have no offsets; the tree stores for each vertex of the mesh a vertex
/// that is posed to the same bits. The tree is the same on every machine.
///
/// Nodes are numbered breadth first. The clusters, children and pool of a node follow those of the
/// previous node, and the triangles and vertices of a cluster those of the previous cluster. A pool
/// is sorted by number of influences, so that a loop over its vertices seldom changes its length.
///
/// Precondition: at least one sample, and finite positions. O((T + V) log(T + V)).
Tree build_tree(const SkinnedMesh& mesh, std::span<const std::vector<Vec3>> samples);

}  // namespace pelt::detail

#pragma once

#include "paper/sphere_tree.hpp"

namespace pelt::paper {

/// A copy of the mesh with its triangles in the order of the tree's leaves, and its vertices in the
/// order in which these triangles first use them (unused vertices are left out). Triangles and
/// vertices that are posed together are then neighbours in memory.
SkinnedMesh in_leaf_order(const SkinnedMesh& mesh, const SphereTree& tree);

}  // namespace pelt::paper

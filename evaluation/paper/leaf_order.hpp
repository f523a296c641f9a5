#pragma once

#include "evaluation/paper/sphere_tree.hpp"

namespace pelt::paper {

/// The same mesh with its triangles in the order of the tree's leaves and its vertices in the order
/// in which these first name them (unused ones left out): triangles and vertices that are posed
/// together stand together.
SkinnedMesh in_leaf_order(const SkinnedMesh& mesh, const SphereTree& tree);

}  // namespace pelt::paper

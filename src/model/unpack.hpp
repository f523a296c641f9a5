#pragma once

/// The mesh of a tree.

#include "model/tree.hpp"
#include "skin/skinned_mesh.hpp"

namespace pelt::detail {

/// Returns the vertices [P] of a tree in their order, without triangles. Precondition:
/// `check_structure` finds no problem.
SkinnedMesh unpack_vertices(const Tree& tree);

/// Returns the mesh with the caller's triangle and vertex numbers. Of welded vertices,
/// triangles refer to the lowest. Precondition: `check_structure` finds no problem. O(P).
SkinnedMesh unpack_mesh(const Tree& tree);

}  // namespace pelt::detail

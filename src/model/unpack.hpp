#pragma once

#include "model/tree.hpp"
#include "skin/skinned_mesh.hpp"

namespace pelt::detail {

/// The vertices [P] of a tree as they lie there, without triangles. Precondition: `check_structure`
/// finds nothing wrong.
SkinnedMesh unpack_vertices(const Tree& tree);

/// The mesh in the caller's numbers of triangles and vertices. Where vertices of the caller's are
/// bit-identical, triangles name the lowest of them. Precondition: `check_tree` finds nothing
/// wrong. O(P log P).
SkinnedMesh unpack_mesh(const Tree& tree);

}  // namespace pelt::detail

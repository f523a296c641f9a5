#pragma once

/// Trees of axis-aligned boxes over posed vertices.
///
/// AabbRefit: van den Bergen 1997, "Efficient collision detection of complex deformable models
/// using AABB trees", section 4: the tree of the rest positions, its boxes taken anew from the
/// leaves to the root. What collision libraries do for meshes that deform.
/// AabbRebuild: the same tree built afresh, which is tighter and dearer.
///
/// Strengthened: built by the surface area heuristic where the source cuts at medians; several
/// triangles in a leaf; leaves are refitted around lists of their vertices, in which none is twice,
/// and in the order in which they lie in memory; both trees are descended at once.

#include "evaluation/rivals/posed_mesh_method.hpp"

#include <memory>

namespace pelt::rivals {

struct TreeOptions {
  std::uint32_t leaf_triangles = 16;  ///< at most; 1 to 32
};

std::unique_ptr<PosedMeshMethod> make_aabb_refit(const TreeOptions& options = {});
std::unique_ptr<PosedMeshMethod> make_aabb_rebuild(const TreeOptions& options = {});

}  // namespace pelt::rivals

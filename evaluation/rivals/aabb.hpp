#pragma once

/// Trees of axis-aligned boxes over posed vertices.
///
/// AabbRefit: van den Bergen 1997, "Efficient collision detection of complex deformable models
/// using AABB trees", section 4: the tree of the rest positions, with its boxes recomputed from the
/// leaves to the root. Collision libraries use this for deforming meshes. AabbRebuild: the same
/// tree, built again, which is tighter and more expensive.
///
/// Strengthened: built by the surface area heuristic, while the source cuts at medians; several
/// triangles per leaf; leaves are refitted from lists of their distinct vertices in memory order;
/// both trees are descended simultaneously.

#include "evaluation/rivals/posed_mesh_method.hpp"

#include <memory>

namespace pelt::rivals {

struct TreeOptions {
  std::uint32_t leaf_triangles = 16;  ///< at most; 1 to 32
};

std::unique_ptr<PosedMeshMethod> make_aabb_refit(const TreeOptions& options = {});
std::unique_ptr<PosedMeshMethod> make_aabb_rebuild(const TreeOptions& options = {});

}  // namespace pelt::rivals

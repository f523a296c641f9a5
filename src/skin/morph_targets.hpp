#pragma once

#include "base/problem.hpp"
#include "skin/skinned_mesh.hpp"

namespace pelt::detail {

/// Checks the morph targets and gives them to the mesh, displacements of zero left out. The mesh
/// has its rest positions already. O(V + M + D).
Problem take_morph_targets(const MorphTargetsView& view, SkinnedMesh& mesh);

}  // namespace pelt::detail

#pragma once

#include "base/problem.hpp"
#include "skin/skinned_mesh.hpp"

namespace pelt::detail {

/// Validates the morph targets and copies their nonzero displacements into the mesh. Precondition:
/// the mesh has its rest positions. O(V + M + D).
Problem take_morph_targets(const MorphTargetsView& view, SkinnedMesh& mesh);

}  // namespace pelt::detail

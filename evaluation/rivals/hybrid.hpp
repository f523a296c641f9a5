#pragma once

/// Larsson & Akenine-Moller 2001, "Collision detection for continuously deforming bodies": a tree
/// of boxes. Every update refits the upper half of the levels bottom-up. Each box below is computed
/// from the vertices below it when a query opens its parent, at most once per update.
///
/// Strengthened like aabb.hpp. In addition, the boxes at the cut, which cost most, are computed
/// from lists of distinct vertices.

#include "evaluation/rivals/aabb.hpp"

#include <memory>

namespace pelt::rivals {

std::unique_ptr<PosedMeshMethod> make_hybrid(const TreeOptions& options = {});

}  // namespace pelt::rivals

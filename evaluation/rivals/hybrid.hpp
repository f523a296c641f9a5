#pragma once

/// Larsson & Akenine-Moller 2001, "Collision detection for continuously deforming bodies": a tree
/// of boxes whose upper half of the levels is refitted bottom-up at every update, whereas the boxes
/// below are computed top-down, each from the vertices below it, where queries open their parents
/// and at most once for each update.
///
/// Strengthened as aabb.hpp; and the boxes at the cut, which cost most, are taken around lists of
/// vertices in which none is twice.

#include "evaluation/rivals/aabb.hpp"

#include <memory>

namespace pelt::rivals {

std::unique_ptr<PosedMeshMethod> make_hybrid(const TreeOptions& options = {});

}  // namespace pelt::rivals

#pragma once

#include "base/problem.hpp"
#include "model/tree.hpp"

namespace pelt::detail {

/// Validates the displacements of a tree's pools, which may come from a hostile file. Returns the
/// first problem, or an empty Problem. Precondition: the nodes are valid. O(N + D).
Problem check_pool_morphs(const Tree& tree);

}  // namespace pelt::detail

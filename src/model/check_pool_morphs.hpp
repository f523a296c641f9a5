#pragma once

#include "base/problem.hpp"
#include "model/tree.hpp"

namespace pelt::detail {

/// The first rule that the displacements of a tree's pools break, which may come from a hostile
/// file; empty when there is none. Precondition: the nodes are sound. O(N + D).
Problem check_pool_morphs(const Tree& tree);

}  // namespace pelt::detail

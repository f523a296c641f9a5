#pragma once

#include "model/tree.hpp"

namespace pelt::detail {

/// Computes Tree::welded_vertices. Precondition: the places and the caller's vertices are in range.
void index_welded_vertices(Tree& tree);

}  // namespace pelt::detail

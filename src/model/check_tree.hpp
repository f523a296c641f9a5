#pragma once

#include "base/problem.hpp"
#include "model/tree.hpp"

namespace pelt::detail {

/// The first rule of a tree's structure that is broken, naming the array and the index; empty when
/// there is none, and then everything that queries do is sound. The tree may come from a hostile
/// file: no array is trusted before it is checked. O(T + P).
Problem check_structure(const Tree& tree);

/// The same, and whether vertices that are alike have been welded as tree.hpp promises. Where they
/// have not, queries are slower, and the caller's numbers of vertices are lost. O(T + P log P).
Problem check_tree(const Tree& tree);

}  // namespace pelt::detail

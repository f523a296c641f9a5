#pragma once

#include "model/tree.hpp"

#include <string>

namespace pelt::detail {

/// The first rule of a tree's structure that is broken, naming the array and the index; empty when
/// the tree is sound, and then everything else may rely on it. The tree may come from a hostile
/// file: no array is trusted before it is checked. O(T + P log P).
std::string check_tree(const Tree& tree);

}  // namespace pelt::detail

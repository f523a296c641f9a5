#pragma once

#include "base/problem.hpp"
#include "model/tree.hpp"

namespace pelt::detail {

/// Validates the structure of a tree that may come from a hostile file. Returns the first problem,
/// with array and index, or an empty Problem; queries are then safe. Uses no array before it is
/// validated. O(T + P).
Problem check_structure(const Tree& tree);

/// Like `check_structure`, and also checks that each vertex of the caller is at most once in a pool
/// and has the same bits in all pools. O(T + P log P).
Problem check_tree(const Tree& tree);

}  // namespace pelt::detail

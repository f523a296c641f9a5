#pragma once

/// Stages of queries on Pelt's tree that the library does not offer alone. Each function is
/// compiled once for each instruction set, like the library.

#include "pose/posed_tree.hpp"
#include "query/scratch.hpp"

namespace pelt::rivals {

/// Descends a tree against itself and returns the number of pairs of different clusters whose boxes
/// overlap. Precondition: all nodes are open.
using DescendSelf = std::uint64_t(const detail::PosedTree& posed, detail::Scratch& scratch);

/// Computes the boxes of all triangles. Precondition: all nodes are open.
using BoxAllTriangles = void(const detail::PosedTree& posed);

/// The functions for the active instruction set.
DescendSelf* active_descend_self();
BoxAllTriangles* active_box_all_triangles();

}  // namespace pelt::rivals

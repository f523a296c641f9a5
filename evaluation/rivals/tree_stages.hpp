#pragma once

/// Stages of queries on Pelt's tree that the library does not offer alone. Each function is
/// compiled once for each instruction set, like the library.

#include "pose/posed_tree.hpp"
#include "query/scratch.hpp"
#include "self/pair_masks.hpp"

namespace pelt::rivals {

/// Descends a tree against itself and returns the number of pairs of clusters whose boxes overlap
/// and that are no neighbours. Precondition: all nodes are open.
using DescendSelf = std::uint64_t(const detail::PosedTree& posed, const detail::PairMasks& masks);

/// Computes the boxes of all triangles on the grid of self-collision. Preconditions: all nodes are
/// open, and the root box is known.
using BoxAllTriangles = void(const detail::PosedTree& posed, const detail::PairMasks& masks,
                             detail::Scratch& scratch);

/// The functions for the active instruction set.
DescendSelf* active_descend_self();
BoxAllTriangles* active_box_all_triangles();

}  // namespace pelt::rivals

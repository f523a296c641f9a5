#pragma once

#include "model/surface.hpp"
#include "pose/posed_tree.hpp"
#include "query/scratch.hpp"
#include "self/self_filter.hpp"

namespace pelt::detail {

/// Writes pairs of triangles of one pose to `scratch.found`, each once, in ascending order.
/// Includes all pairs that intersect, apart from vertices that they share, after an infinitesimal
/// motion of the vertices. Opens all nodes.
///
/// `neighbours`: leaves out nothing.
QueryStats find_self_pairs(const PosedTree& posed, const Surface& surface,
                           const SelfFilter& neighbours, Scratch& scratch);

}  // namespace pelt::detail

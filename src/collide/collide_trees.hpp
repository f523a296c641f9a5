#pragma once

#include "base/instruction_set.hpp"
#include "pose/posed_tree.hpp"
#include "query/scratch.hpp"

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {

/// Writes at most `max_contacts` pairs of intersecting triangles to `scratch.found`, in no
/// particular order.
QueryStats collide_trees(const PosedTree& a, const PosedTree& b, Scratch& scratch,
                         std::uint32_t max_contacts);

/// Like `collide_trees`, but stops after `max_work` units of `work_of`, too. `cut_short` then says
/// so.
QueryStats collide_trees_within(const PosedTree& a, const PosedTree& b, Scratch& scratch,
                                std::uint32_t max_contacts, std::uint64_t max_work);

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail

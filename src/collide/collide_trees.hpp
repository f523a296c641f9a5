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

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail

#pragma once

#include <pelt/collide.hpp>

#include "base/instruction_set.hpp"
#include "pose/posed_tree.hpp"

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {

/// Computes every bound that a query could need: the root box, all nodes, and the boxes of all
/// triangles. Returns the work. Precondition: the table of opened nodes exists.
QueryStats compute_all_bounds(const PosedTree& posed);

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail

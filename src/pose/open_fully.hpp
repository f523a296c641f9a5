#pragma once

#include <pelt/collide.hpp>

#include "base/target.hpp"
#include "pose/posed_tree.hpp"

namespace pelt::detail {
inline namespace PELT_TARGET {

/// Computes every bound that a query could need: the root box, all nodes, and the boxes of all
/// triangles. Returns the work. Precondition: the table of opened nodes exists.
QueryStats open_fully(const PosedTree& posed);

}  // namespace PELT_TARGET
}  // namespace pelt::detail

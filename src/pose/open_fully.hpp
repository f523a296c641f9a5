#pragma once

#include <pelt/collide.hpp>

#include "base/target.hpp"
#include "pose/posed_tree.hpp"

namespace pelt::detail {
inline namespace PELT_TARGET {

/// Computes every bound that a query could ask for: the box around the root, all nodes, the boxes
/// of all triangles. Returns the work. Precondition: there is a table of opened nodes.
QueryStats open_fully(const PosedTree& posed);

}  // namespace PELT_TARGET
}  // namespace pelt::detail

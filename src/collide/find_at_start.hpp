#pragma once

#include <pelt/motion.hpp>

#include "pose/posed_tree.hpp"
#include "query/scratch.hpp"

#include <optional>

namespace pelt::detail {

/// Sets `first` to the lowest pair of triangles that intersect at time 0. If there is none, `first`
/// is empty.
QueryStats find_at_start(const PosedTree& a, const PosedTree& b, Scratch& scratch,
                         std::optional<MovingContact>& first);

}  // namespace pelt::detail

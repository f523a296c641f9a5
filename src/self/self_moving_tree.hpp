#pragma once

#include <pelt/self.hpp>

#include "motion/moving_tree.hpp"
#include "self/self_filter.hpp"

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {

/// Writes the pairs of triangles of one character that intersect at some time of a step, and that
/// the filter does not leave out, to `scratch.moving`, in no particular order.
SelfMovingStats self_collide_moving_tree(const MovingTree& moving, const SelfFilter& filter,
                                         Scratch& scratch, const MovingOptions& options);

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail

#pragma once

#include <pelt/motion.hpp>

#include "base/instruction_set.hpp"
#include "motion/moving_tree.hpp"
#include "query/scratch.hpp"

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {

/// Writes at most `options.max_contacts` pairs of triangles that intersect at some time to
/// `scratch.moving`, in no particular order.
MovingStats collide_moving_trees(const MovingTree& a, const MovingTree& b, Scratch& scratch,
                                 const MovingOptions& options);

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail

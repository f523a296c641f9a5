#pragma once

#include <pelt/motion.hpp>

#include "base/instruction_set.hpp"
#include "field/height_field.hpp"
#include "motion/moving_tree.hpp"
#include "query/scratch.hpp"

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {

/// Writes at most `options.max_contacts` pairs of triangles of a moving tree and the field that
/// intersect at some time to `scratch.moving`, in no particular order.
MovingStats collide_moving_field(const MovingTree& moving, const HeightField& field,
                                 Scratch& scratch, const MovingOptions& options);

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail

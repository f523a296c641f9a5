#pragma once

#include <pelt/motion.hpp>

#include "base/instruction_set.hpp"
#include "motion/moving_tree.hpp"
#include "query/scratch.hpp"
#include "solid/prepared_region.hpp"

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {

/// Writes at most `options.max_contacts` triangles of a moving tree that touch a region at some
/// time to `scratch.moving`, in no particular order. `triangle_b` and the features have no meaning.
MovingStats descend_moving_in_faces(const MovingTree& moving, const FacesRegion& region,
                                    Scratch& scratch, const MovingOptions& options);
MovingStats descend_moving_in_capsule(const MovingTree& moving, const CapsuleRegion& region,
                                      Scratch& scratch, const MovingOptions& options);

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail

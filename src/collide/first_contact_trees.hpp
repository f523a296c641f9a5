#pragma once

#include <pelt/motion.hpp>

#include "base/instruction_set.hpp"
#include "motion/moving_tree.hpp"
#include "query/scratch.hpp"

#include <optional>

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {

/// Sets `first` to the first contact after the start: of the pairs of triangles that do not
/// intersect at time 0, the one that intersects first; of equal times, the lowest. Without such a
/// pair, `first` is empty.
MovingStats first_contact_of_trees(const MovingTree& a, const MovingTree& b, Scratch& scratch,
                                   std::optional<MovingContact>& first);

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail

#pragma once

#include <pelt/motion.hpp>

#include "base/instruction_set.hpp"
#include "collide/first_contact_state.hpp"
#include "motion/moving_tree.hpp"

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {

/// Starts a search: compares the root boxes, and adds the first item if they may overlap.
/// Precondition: the state is clear.
MovingStats start_first_contact(const MovingTree& a, const MovingTree& b, FirstContactState& state);

/// Makes steps until the granted work is done or nothing is open. Precondition: the state was
/// started with the same poses, which have not changed since.
MovingStats advance_first_contact(const MovingTree& a, const MovingTree& b,
                                  FirstContactState& state);

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail

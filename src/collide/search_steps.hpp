#pragma once

#include "base/instruction_set.hpp"
#include "collide/search_state.hpp"
#include "pose/posed_tree.hpp"

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {

/// Starts a search anew: compares the root boxes, and adds the first item if they overlap.
QueryStats start_search(const PosedTree& a, const PosedTree& b, SearchState& state);

/// Makes steps until the granted work is done, nothing is open or, in the order `first_contact`,
/// the first contact is found. Precondition: the state was started with the same poses, which have
/// not changed since.
QueryStats advance_search(const PosedTree& a, const PosedTree& b, SearchState& state);

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail

#pragma once

#include <pelt/collide.hpp>

#include "base/instruction_set.hpp"
#include "pose/posed_tree.hpp"
#include "query/scratch.hpp"

#include <optional>

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {

/// Sets `lowest` to the lowest pair of intersecting triangles, the first that `collide` lists.
/// Empty if none intersect. Overwrites `scratch.found`.
QueryStats lowest_contact(const PosedTree& a, const PosedTree& b, Scratch& scratch,
                          std::optional<Contact>& lowest);

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail

#pragma once

#include "base/instruction_set.hpp"
#include "field/height_field.hpp"
#include "pose/posed_tree.hpp"
#include "query/scratch.hpp"

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {

/// Writes at most `max_contacts` pairs of intersecting triangles of the pose and the field to
/// `scratch.found`, in no particular order.
QueryStats collide_field(const PosedTree& posed, const HeightField& field, Scratch& scratch,
                         std::uint32_t max_contacts);

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail

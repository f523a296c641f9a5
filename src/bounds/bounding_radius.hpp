#pragma once

#include "base/instruction_set.hpp"
#include "model/node_bounds.hpp"
#include "skin/palette.hpp"

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {

/// Returns an upper bound of the distance of posed vertices from `centre` (four floats), or
/// infinity if the bound of the root node is affine. Precondition: no coordinate of `centre`
/// exceeds 2^64.
float bounding_radius(const NodeBounds& bounds, const Palette& palette, const float* centre);

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail

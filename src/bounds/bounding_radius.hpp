#pragma once

#include "base/target.hpp"
#include "model/node_bounds.hpp"
#include "skin/palette.hpp"

namespace pelt::detail {
inline namespace PELT_TARGET {

/// Returns an upper bound of the distance of posed vertices from `centre` (four floats), or
/// infinity if the joint palette alone gives no bound. Precondition: no coordinate of `centre`
/// exceeds 2^64.
float bounding_radius(const NodeBounds& bounds, const Palette& palette, const float* centre);

}  // namespace PELT_TARGET
}  // namespace pelt::detail

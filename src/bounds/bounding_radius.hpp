#pragma once

#include "base/target.hpp"
#include "model/node_bounds.hpp"
#include "skin/palette.hpp"

namespace pelt::detail {
inline namespace PELT_TARGET {

/// No vertex below the root is posed further from `centre` (four floats); infinity if the joint
/// palette alone does not say. Precondition: no coordinate of it is larger than 2^64.
float bounding_radius(const NodeBounds& bounds, const Palette& palette, const float* centre);

}  // namespace PELT_TARGET
}  // namespace pelt::detail

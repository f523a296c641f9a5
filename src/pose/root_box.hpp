#pragma once

#include "base/instruction_set.hpp"
#include "model/node_bounds.hpp"
#include "skin/palette.hpp"

namespace pelt::detail {

/// Box of all vertices, computed when first needed.
struct RootBox {
  bool known = false;
  float low[4], high[4];
};

inline namespace PELT_INSTRUCTION_SET {

/// Computes the box from the joint palette and the morph weights, without posing vertices.
RootBox box_root(const NodeBounds& bounds, const Palette& palette);

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail

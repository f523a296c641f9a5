#pragma once

#include "base/target.hpp"
#include "model/node_bounds.hpp"
#include "pose/opened_node.hpp"
#include "skin/palette.hpp"

namespace pelt::detail {
inline namespace PELT_TARGET {

/// A box around the whole instance, from the joint palette alone.
RootBox instance_box(const NodeBounds& bounds, const Palette& palette);

}  // namespace PELT_TARGET
}  // namespace pelt::detail

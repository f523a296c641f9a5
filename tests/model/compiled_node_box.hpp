#pragma once

#include "model/node_bounds.hpp"
#include "skin/palette.hpp"
#include "support/compiled.hpp"

namespace pelt::test {

/// The lowest and highest corner of a box.
struct PlainBox {
  float low[3], high[3];

  friend bool operator==(const PlainBox&, const PlainBox&) = default;
};

using NodeBoxFunction = PlainBox(const detail::NodeBounds& bounds, std::uint32_t node,
                                 const detail::Palette& palette);

/// detail::node_box.
PELT_DECLARE_COMPILED(NodeBoxFunction, compiled_node_box)

/// detail::dual_box with this tolerance.
using DualBoxFunction = PlainBox(const detail::NodeBounds& bounds, std::uint32_t node,
                                 const detail::Palette& palette, float tolerance);
PELT_DECLARE_COMPILED(DualBoxFunction, compiled_dual_box)

}  // namespace pelt::test

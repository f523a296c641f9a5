#pragma once

#include "model/node_bounds.hpp"
#include "skin/palette.hpp"

#include <pelt/config.hpp>

namespace pelt::test {

/// The lowest and highest corner of a box.
struct PlainBox {
  float low[3], high[3];

  friend bool operator==(const PlainBox&, const PlainBox&) = default;
};

using NodeBoxFunction = PlainBox(const detail::NodeBounds& bounds, std::uint32_t node,
                                 const detail::Palette& palette);

/// detail::node_box, as compiled for each instruction set.
namespace avx2 {
NodeBoxFunction compiled_node_box;
}
namespace simd128 {
NodeBoxFunction compiled_node_box;
}
namespace scalar {
NodeBoxFunction compiled_node_box;

/// detail::dual_box with this tolerance.
PlainBox compiled_dual_box(const detail::NodeBounds& bounds, std::uint32_t node,
                           const detail::Palette& palette, float tolerance);
}  // namespace scalar

struct CompiledNodeBox {
  InstructionSet set;
  NodeBoxFunction* node_box;
};

inline constexpr CompiledNodeBox kCompiledNodeBoxes[] = {
    {InstructionSet::scalar, scalar::compiled_node_box},
#ifdef PELT_HAS_SIMD128
    {InstructionSet::simd128, simd128::compiled_node_box},
#endif
#ifdef PELT_HAS_AVX2
    {InstructionSet::avx2, avx2::compiled_node_box},
#endif
};

}  // namespace pelt::test

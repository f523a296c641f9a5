#pragma once

/// Certifies that no two triangles around a vertex intersect, apart from the vertex and the edges
/// that they share. The triangles around a vertex of a smooth surface can be projected onto a plane
/// such that they surround the vertex once, like the slices of a cake. One test of k triangles then
/// replaces tests of k (k - 1) / 2 pairs.

#include "base/instruction_set.hpp"
#include "self/fans.hpp"

#include <cstdint>

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {

/// Posed vertices by place, four floats each.
using Positions = const std::array<float, 4>*;

/// Returns which of eight closed or open fans with the same kind and the same number of triangles
/// are certified, one bit per fan. `first` is the first of `count` <= 8 fans.
unsigned flat_fans(const Fans& fans, FanKind kind, std::uint32_t first, std::uint32_t count,
                   Positions positions);

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail

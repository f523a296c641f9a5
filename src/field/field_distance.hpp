#pragma once

#include "distance/pair_search.hpp"
#include "field/height_field.hpp"

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {

/// Finds the least distance of a pose and a field that do not touch, like `closest_triangles` for
/// two poses. The first two slots are the cluster, the third is a block of the lowest level.
QueryStats closest_field_triangle(const PosedTree& posed, const HeightField& field,
                                  Scratch& scratch, const SearchLimits& limits,
                                  TriangleGap& closest);

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail

#pragma once

#include "distance/pair_search.hpp"
#include "field/height_field.hpp"

namespace pelt::detail {
inline namespace PELT_TARGET {

/// Finds the least distance of a pose and a field that do not touch, like `nearest_triangles` for
/// two poses. The first two places are the cluster, the third is a block of the lowest level.
QueryStats nearest_field_triangle(const PosedTree& posed, const HeightField& field,
                                  Scratch& scratch, const SearchLimits& limits,
                                  TriangleGap& nearest);

}  // namespace PELT_TARGET
}  // namespace pelt::detail

#pragma once

#include "geometry/points8.hpp"
#include "self/neighbour_separation.hpp"

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {

/// Eight pairs of moving triangles that share one corner, or two, as vectors rounded to float.
using CornerNeighbours8 = CornerNeighbours<Points8>;
using EdgeNeighbours8 = EdgeNeighbours<Points8>;

/// Returns the pairs that certainly never intersect, apart from what they share, one bit each.
/// Decides nearly all pairs of a smooth surface. Precondition: that of `triage` for the
/// coordinates.
unsigned certainly_apart(const CornerNeighbours8& pairs);
unsigned certainly_apart(const EdgeNeighbours8& pairs);

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail

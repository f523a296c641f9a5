#pragma once

/// The certified float test of eight pairs of triangles.

#include "base/float8.hpp"

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {

/// Eight pairs of triangles in structure-of-arrays order: lane i of `a` and `b` is pair i.
struct TrianglePairs8 {
  Points8 a[3], b[3];
};

/// Decisions about eight pairs, one bit per pair. A pair in neither set is undecided.
struct Triage {
  unsigned apart = 0, intersecting = 0;
};

/// Decides nearly all pairs in general position, with the answer of `triangles_intersect`, for a
/// tenth of its cost. Undecided pairs are those that touch or nearly touch, coplanar pairs, most
/// pairs with collapsed triangles, and many pairs in which one triangle is a hundred times larger
/// than the other.
///
/// Precondition: no coordinate exceeds 2^60 by more than the rounding of a posed vertex, which is
/// less than a 64th.
Triage triage(const TrianglePairs8& pairs);

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail

#pragma once

#include "base/float8.hpp"

namespace pelt::detail {
inline namespace PELT_TARGET {

/// Eight pairs of triangles, corner by corner: lane i of `a` and of `b` is pair i.
struct TrianglePairs8 {
  Points8 a[3], b[3];
};

/// What is certain about eight pairs, a bit each. A pair in neither set is undecided.
struct Triage {
  unsigned apart = 0, intersecting = 0;
};

/// Decides nearly all pairs in general position as `triangles_intersect` would, for a tenth of its
/// cost. Undecided remain pairs that touch or all but touch, coplanar ones, most that have
/// collapsed, and many of which one triangle is a hundred times larger than the other.
/// Precondition: no coordinate is larger than 2^60, but for the rounding of a posed vertex: less
/// than a 64th.
Triage triage(const TrianglePairs8& pairs);

}  // namespace PELT_TARGET
}  // namespace pelt::detail

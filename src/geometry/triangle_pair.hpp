#pragma once

#include <pelt/math.hpp>

#include <array>
#include <cstdint>

namespace pelt::detail {

/// Corners of a posed triangle.
using TriangleCorners = std::array<Vec3, 3>;

/// Whether two closed triangles intersect, decided exactly on their float32 coordinates.
///
/// Touching counts, coplanar overlap counts, and a triangle that has collapsed to a segment or a
/// point is that segment or point. Symmetric in its arguments and independent of the order of the
/// corners. Precondition: all coordinates are finite.
bool triangles_intersect(const TriangleCorners& a, const TriangleCorners& b);

/// How often the stages of the predicate decided, on this thread; for tests that must see the exact
/// stage run.
struct PredicateCounters {
  std::uint64_t filtered = 0;  ///< signs that the double filter decided
  std::uint64_t exact = 0;     ///< signs that needed exact arithmetic
};
PredicateCounters& predicate_counters();

}  // namespace pelt::detail

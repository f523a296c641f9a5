#pragma once

/// Computes the part of the flux of w through a surface that comes from the crossing of two of its
/// triangles. w is the winding number of the surface in front of it.
///
/// On a triangle (c, d, e), w jumps across the segments in which other triangles cross it. With the
/// formulas of crossing_flux.hpp, the flux is the sum of
///
///     w(d) det(c, d, e)        where w(d) is that at the start of the edge de,
///     j (1 - t) det(c, d, e)   for each jump j on the edge de, at d + t (e - d), and
///     det(c, p, q)             for each segment pq.
///
/// The first is added in self_flux.cpp.

#include "query/scratch.hpp"
#include "volume/surface_crossing.hpp"

namespace pelt::detail {

/// Precondition, here and below: `crossing` is that of `a` and `b`.
Rounded flux_of(const SurfaceCrossing& crossing, const NumberedTriangle& a,
                const NumberedTriangle& b, const Vec3& origin);

/// Returns how the winding number in front of a turns along its outline. `place`: of a.
OutlineTurns turns_of_a(const SurfaceCrossing& crossing, std::uint32_t place);

/// The same for b.
OutlineTurns turns_of_b(const SurfaceCrossing& crossing, std::uint32_t place);

}  // namespace pelt::detail

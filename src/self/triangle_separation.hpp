#pragma once

#include "geometry/triangle_triage.hpp"

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {

/// Returns lower bounds of the distances of eight pairs of triangles: the largest gap between their
/// projections onto the normals and onto the directions in their planes that are perpendicular to
/// an edge. 0 if none of these eight directions certainly separates the triangles. Precondition: no
/// coordinate exceeds 2^60, as for `triage`.
Float8 separations(const TrianglePairs8& pairs);

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail

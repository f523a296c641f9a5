#pragma once

#include "geometry/triangle_triage.hpp"

#include <cstdint>

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {

/// Writes the squared distances of the first `count` of eight pairs, with the same bits as
/// `closest_points` (triangle_distance.hpp), at a fifth of its cost. Precondition: the pairs do not
/// touch.
void squared_distances(const TrianglePairs8& pairs, std::uint32_t count, double (&squared)[8]);

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail

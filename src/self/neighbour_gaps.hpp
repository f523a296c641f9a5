#pragma once

/// Tests neighbouring clusters, and measures how far apart their triangles are.

#include "collide/cluster_pair.hpp"
#include "query/slots.hpp"

#include <cstdint>

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {

/// Appends the intersecting pairs of triangles of two clusters, like `TrianglePairs::add` with
/// `skipped`. Returns a lower bound of the distance of all pairs that were not skipped, at most a
/// small share of the size of the smaller cluster's box, or 0 if not all of them are certainly
/// apart.
///
/// Precondition: no coordinate of the clusters' vertices is larger than `extent`.
///
/// Costs about twice as much as `TrianglePairs::add`.
float test_gaps(const PosedCluster& a, const PosedCluster& b,
                const std::uint16_t (&skipped)[kMaxClusterTriangles], float extent,
                TrianglePairs& pairs, QueryStats& work);

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail

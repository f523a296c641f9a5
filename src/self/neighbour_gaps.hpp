#pragma once

/// Tests neighbouring clusters, and finds out how far apart their triangles are.

#include "collide/cluster_pair.hpp"
#include "query/slots.hpp"

#include <cstdint>

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {

/// Tests the pairs of triangles of two clusters as `TrianglePairs::add` does, also without the
/// pairs in `skipped`. Returns a lower bound of the distance of all pairs that were not skipped, or
/// 0 if some may touch. No coordinate of the clusters' vertices is larger than `extent`.
///
/// Costs about twice as much as `TrianglePairs::add`.
float test_gaps(const PosedCluster& a, const PosedCluster& b,
                const std::uint16_t (&skipped)[kMaxClusterTriangles], float extent,
                TrianglePairs& pairs, QueryStats& work);

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail

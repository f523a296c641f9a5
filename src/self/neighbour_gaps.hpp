#pragma once

/// Tests neighbouring clusters, and measures how far apart their triangles are.

#include "collide/cluster_pair.hpp"
#include "geometry/triangle_triage.hpp"
#include "query/slots.hpp"
#include "self/self_filter.hpp"

#include <cstdint>

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {

using SelfTrianglePairs = TrianglePairs<FilteredSink<Contact>>;

/// Returns lower bounds of the distances of eight pairs of triangles: the largest gap between their
/// projections onto the normals and onto the directions in their planes that are perpendicular to
/// an edge. 0 if none of these eight directions certainly separates the triangles. Precondition: no
/// coordinate exceeds 2^60, as for `triage`.
Float8 separations(const TrianglePairs8& pairs);

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
                SelfTrianglePairs& pairs, QueryStats& work);

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail

#pragma once

/// What two crossing triangles contribute to the flux of w_b through the surface of a plus the flux
/// of w_a through the surface of b.
///
/// On a triangle (c, d, e) of a, w_b jumps across the segments in which triangles of b cross it,
/// and along the edges at their ends. Its flux through the triangle is the sum of
///
///     w_b(c) det(c, d, e)      as if w_b were constant,
///     j det(c, d, e)           for each jump j on the edge cd,
///     j (1 - t) det(c, d, e)   for each jump j on the edge de, at d + t (e - d), and
///     det(c, p, q)             for each segment pq. The inside of b is on its left.
///
/// (The triangle consists of polygons with constant w_b, whose sides are parts of edges, and
/// segments. If a side is part of an edge at c, det(c, p, q) = 0. For sides on de, w_b depends on
/// the jumps on cd.)
///
/// Segments run in the direction n_a x n_b. For the triangle of b with first corner c', a segment
/// runs in the opposite direction, so it contributes det(c, p, q) - det(c', p, q) to both. The term
/// with w_b(c) is added in winding_flux.cpp.

#include "query/scratch.hpp"
#include "volume/generic_crossing.hpp"

namespace pelt::detail {

/// How the crossing of two triangles contributes.
struct CrossingFlux {
  Rounded flux;
  WindingTurns turns_a, turns_b;
};

/// Precondition: `crossing` is that of `a` and `b`.
CrossingFlux flux_of(const GenericCrossing& crossing, const TriangleCorners& a,
                     const TriangleCorners& b, const Vec3& origin);

}  // namespace pelt::detail

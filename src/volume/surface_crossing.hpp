#pragma once

/// Intersections of two triangles of one surface in general position
/// (volume/perturbed_points.hpp). Triangles that share no point intersect in a segment, whose
/// ends are where an edge of one pierces the other. Triangles that share one point may intersect in
/// a segment from this point. Triangles that share two points do not intersect elsewhere, because
/// their planes differ.

#include "volume/perturbed_points.hpp"

#include <array>
#include <cstdint>
#include <optional>

namespace pelt::detail {

/// One end of the segment: on an edge of one triangle, or at a corner of both. Edge i leads from
/// corner i to the next corner.
struct SegmentEnd {
  std::uint8_t a = 0, b = 0;  ///< the edge or corner of either triangle

  /// How the outline of either triangle passes the plane of the other here, counter-clockwise: 1 to
  /// its back, -1 to its front, 0 not at all. Only at a corner, neither is 0.
  std::int8_t turn_a = 0, turn_b = 0;

  bool is_corner() const { return turn_a != 0 && turn_b != 0; }
};

/// The ends of the segment, in the direction n_a x n_b of the normals.
using SurfaceCrossing = std::array<SegmentEnd, 2>;

/// Returns how two triangles intersect, apart from points that they share; nullopt if they do not.
/// Exact. Precondition: neither triangle has two points with the same number.
std::optional<SurfaceCrossing> cross_on_surface(const NumberedTriangle& a,
                                                const NumberedTriangle& b);

}  // namespace pelt::detail

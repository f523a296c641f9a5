#pragma once

/// Points in general position, for any points: each point is moved by an infinitesimal vector of
/// its own (simulation of simplicity, Edelsbrunner & Muecke 1990). No four points are then in one
/// plane, and no three are in one line along any axis.
///
/// Point n is moved by (e^(2^3n), e^(2^(3n + 1)), e^(2^(3n + 2))), for all small enough e > 0. A
/// determinant of four points is a polynomial in e. Its exponents are distinct, because each is a
/// number whose bits say which coordinates of which points are factors. The term with the least
/// exponent that is not zero decides the sign. The term without any such factor is the determinant
/// of the points as they are.
///
/// All decisions about all points are decisions about one configuration, so they are consistent.
/// Functions that are continuous in the positions, such as volumes, have the value at e = 0.

#include <pelt/math.hpp>

#include "exact/exact_number.hpp"

#include <array>
#include <cstdint>
#include <optional>

namespace pelt::detail {

/// A point. Equal numbers must have equal positions.
struct NumberedPoint {
  Vec3 at;
  std::uint32_t number = 0;
};

using NumberedTriangle = std::array<NumberedPoint, 3>;

/// Returns 1 if a point is in front of a triangle's plane, -1 if it is behind. Exact. Precondition:
/// the four numbers are different.
int perturbed_side(const NumberedTriangle& plane, const NumberedPoint& point);

/// Returns 1 if a triangle's normal points along +x, -1 if along -x. Exact. Precondition: the three
/// numbers are different.
int perturbed_facing(const NumberedTriangle& triangle);

/// Returns where the edge between two points on different sides of a plane crosses it, without the
/// infinitesimal motion: 0 at `from`, 1 at `to`. Precondition: the five numbers are different.
Rounded perturbed_share(const NumberedTriangle& plane, const NumberedPoint& from,
                        const NumberedPoint& to);

// Intersections of two triangles of one surface, of such points. Triangles that share no point
// intersect in a segment, whose ends are where an edge of one pierces the other. Triangles that
// share one point may intersect in a segment from this point. Triangles that share two points do
// not intersect elsewhere, because their planes differ.

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

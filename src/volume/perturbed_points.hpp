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

}  // namespace pelt::detail

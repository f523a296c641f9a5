#pragma once

/// Eight triangles at once in float32, passed over where a line certainly misses them.
///
/// Let z be the axis along which the direction is longest, and s the two slopes d_x / d_z and
/// d_y / d_z, no larger than 1. Sheared by them the line is parallel to z, so a corner p is seen at
///     X = (p_x - o_x) - s_x (p_z - o_z),  Y likewise,
/// and an edge from p to q passes the line on the side of X_p Y_q - Y_p X_q, which is the
/// determinant of ray_triangle.cpp over d_z (Woop, Benthin & Wald 2013, "Watertight ray/triangle
/// intersection"; exactness comes from the other file). Where two edges certainly pass on different
/// sides, the line misses the triangle.
///
/// Rounding, with u = 2^-24. Let L be the largest computed |p - o| on any axis and W the largest
/// |X| or |Y|. X gathers 2 u L of the first difference and its own rounding, and 4 u L of the
/// second, of the slope, the product and the sum: 6 u L. The two products of an edge carry that
/// twice each, so with roundings of 4 u W^2, W <= 2 L and terms of second order the edge is wrong
/// by at most
///     24.1 u L W + 73 u^2 L^2 + 4.1 u W^2 <= 40 u L (W + 4 u L).
/// Products that underflow add 2^-150 to X, times W < 2^64, and 2^-84 covers that. Where anything
/// overflows the bound is infinite or NaN, and nothing is certain.

#include "base/float8.hpp"

#include <pelt/math.hpp>

namespace pelt::detail {
inline namespace PELT_TARGET {

/// A line, prepared for many triangles.
struct ShearedLine {
  int x, y, z;  ///< the axes, z the one along which the direction is longest
  float origin_x, origin_y, origin_z, slope_x, slope_y;
};

/// Precondition: the direction is not zero.
ShearedLine shear(const Vec3& origin, const Vec3& direction);

/// The triangles that are not certainly missed, a bit each. Corner by corner: lane i is triangle i.
unsigned not_missed(const ShearedLine& line, const Points8 (&corners)[3]);

}  // namespace PELT_TARGET
}  // namespace pelt::detail

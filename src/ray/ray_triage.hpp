#pragma once

/// Tests eight triangles at once in float32. Decides a triangle only if rounding cannot have
/// changed a sign.
///
/// Let z be the axis of the largest component of the direction, and s the two slopes d_x / d_z and
/// d_y / d_z, which are at most 1. A shear by s makes the line parallel to z. A vertex p then has
/// the coordinates
///     X = (p_x - o_x) - s_x (p_z - o_z),  and Y likewise,
/// and an edge from p to q passes the line on the side of X_p Y_q - Y_p X_q, which is the
/// determinant of ray_triangle.cpp over d_z (Woop, Benthin & Wald 2013, "Watertight ray/triangle
/// intersection"; exactness comes from ray_triangle.cpp). If two edges certainly pass on different
/// sides, the line misses the triangle. If all edges certainly pass on one side, the line hits the
/// triangle away from its edges.
///
/// Rounding, with u = 2^-24. Let L be the largest computed |p - o| on any axis and W the largest
/// |X| or |Y|. The error of X is 6 u L: 2 u L from the first difference and the rounding of X
/// itself, and 4 u L from the second difference, the slope, the product and the sum. The two
/// products of an edge have this error twice each. With roundings of 4 u W^2, W <= 2 L and terms of
/// second order, the error of the edge is at most
///     24.1 u L W + 73 u^2 L^2 + 4.1 u W^2 <= 40 u L (W + 4 u L).
/// Underflow adds 2^-150 to X or to an edge. This is negligible if L is 2^-120 or more; otherwise
/// 2^-84 covers it. Products are at most 2 L W. If 40 L W overflows before it is multiplied by u,
/// the bound is infinite or NaN, and nothing is certain.

#include "base/float8.hpp"

#include <pelt/math.hpp>

#include <cmath>

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {

/// A line, prepared for many triangles.
struct ShearedLine {
  int x, y, z;  ///< z: the axis of the largest component of the direction
  float origin_x, origin_y, origin_z, slope_x, slope_y;
  bool is_backward;  ///< against z: the determinants have the other sign
};

/// Precondition: the direction is not zero.
inline ShearedLine shear(const Vec3& origin, const Vec3& direction) {
  const float o[3] = {origin.x, origin.y, origin.z};
  const double d[3] = {direction.x, direction.y, direction.z};
  const auto length = [&](int axis) { return std::fabs(d[axis]); };
  int z = length(1) > length(0) ? 1 : 0;
  if (length(2) > length(z)) z = 2;
  const int x = z == 2 ? 0 : z + 1, y = z == 0 ? 2 : z - 1;
  const double per_z = 1 / d[z];
  return {x,
          y,
          z,
          o[x],
          o[y],
          o[z],
          static_cast<float>(d[x] * per_z),
          static_cast<float>(d[y] * per_z),
          d[z] < 0};
}

/// The corners of eight triangles in the coordinates of a sheared line, and their distances from
/// its origin.
struct SeenCorners {
  Float8 x, y, distance;
};

/// Looks up the axes, because a branch would often be mispredicted.
[[gnu::always_inline]] inline SeenCorners see(const ShearedLine& line, const Points8& corners) {
  const Float8 axes[] = {corners.x, corners.y, corners.z};
  const Float8 x = axes[line.x] - Float8(line.origin_x), y = axes[line.y] - Float8(line.origin_y);
  const Float8 z = axes[line.z] - Float8(line.origin_z);
  return {x - Float8(line.slope_x) * z, y - Float8(line.slope_y) * z,
          max(max(abs(x), abs(y)), abs(z))};
}

[[gnu::always_inline]] inline Float8 edge_side(const SeenCorners& p, const SeenCorners& q) {
  return p.x * q.y - p.y * q.x;
}

/// Decisions about eight triangles, one bit each; a triangle in neither set is undecided. A
/// triangle is hit from the front if the determinants are negative.
struct RayTriage {
  unsigned missed, met_from_front, met_from_back;
};

/// `corner(k)` returns the corners k of all triangles.
template <typename Corner>
[[gnu::always_inline]] inline RayTriage triage(const ShearedLine& line, const Corner& corner) {
  const SeenCorners a = see(line, corner(0)), b = see(line, corner(1)), c = see(line, corner(2));
  const Float8 ab = edge_side(a, b), bc = edge_side(b, c), ca = edge_side(c, a);
  const Float8 distance = max(max(a.distance, b.distance), c.distance);
  const Float8 width =
      max(max(max(abs(a.x), abs(b.x)), max(abs(c.x), abs(a.y))), max(abs(b.y), abs(c.y)));
  const Float8 error =
      Float8(40.0f) * distance * (width + Float8(0x1p-22f) * distance) * Float8(0x1p-24f) +
      Float8(0x1p-84f);
  const Float8 minus_error = Float8(0.0f) - error;
  const Float8 least = min(min(ab, bc), ca), most = max(max(ab, bc), ca);
  const unsigned missed = ((error < most) & (least < minus_error)).bits();
  const unsigned met_left = (error < least).bits(), met_right = (most < minus_error).bits();
  return line.is_backward ? RayTriage{missed, met_left, met_right}
                          : RayTriage{missed, met_right, met_left};
}

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail

#pragma once

/// Tests of a ray against eight boxes, or against eight triangles, at once in float32. Rounding is
/// on the safe side.

#include <pelt/math.hpp>
#include <pelt/ray.hpp>

#include "base/float8.hpp"
#include "pose/pose_boxes.hpp"
#include "pose/posed_tree.hpp"
#include "query/slots.hpp"

#include <cmath>
#include <cstdint>
#include <cstring>

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {

// Eight boxes at once: a box is entered if any point of the ray within the box of all vertices
// might be inside it.
//
// The direction is divided by a power of two so that its largest component is at least 1 and below
// 2; here, t is the ray's t times this power. On an axis with direction d > 0, the box spans t
// from (low - o) / d to (high - o) / d. Move o by a margin m, up for the first and down for the
// second. Three roundings and those of o + m then increase the first to at most (low - o) / d if
//     m >= 4.1 2^-24 (|low| + |o| + m).
// The coordinates of a point of the ray that counts are at most B, the bound of the box of all
// vertices, and the rounded quotient increases with `low`, so |low| counts at most as B. This
// gives m = 2^-21 (B + |o|). If |d| is below 2^-126 or zero, the reciprocal 2^126 replaces it, as
// if the direction were changed by 2^-126: t is at most T = max B + max |o| over the axes, so the
// ray moves by less than 2^-125 T, and in the box a t of T is reached within 2^-126 T. 2^-60 T,
// added to m, covers both, and 2^-140 covers underflow. Nothing becomes NaN: reciprocals are
// finite and not zero, and o is finite.

class RaySlabs {
 public:
  /// Preconditions: the box is not empty, the direction not zero.
  RaySlabs(const Ray& ray, const RootBox& all) {
    const double origin[3] = {ray.origin.x, ray.origin.y, ray.origin.z};
    const double direction[3] = {ray.direction.x, ray.direction.y, ray.direction.z};
    double bound[3];
    for (unsigned a = 0; a < 3; ++a) bound[a] = larger(all.low[a], all.high[a]);
    scale_ = power_of_two(largest(direction));
    const double shrink = 1 / scale_;
    const double farthest = largest(bound) + largest(origin);
    for (unsigned a = 0; a < 3; ++a)
      axes_[a] =
          make_axis(origin[a], direction[a] * shrink, bound[a] + std::fabs(origin[a]), farthest);
    first_ = scaled(ray.t_min, -1);
    last_ = scaled(ray.t_max, 1);
  }

  /// Ignores everything beyond `t` from now on.
  void end_at(float t) { last_ = scaled(t, 1); }

  /// Whether a box entered at `entry` may still contain a hit that counts.
  bool reaches(float entry) const { return entry <= last_; }

  /// Whether the ray enters the box around all vertices.
  bool enters(const RootBox& all) const {
    const float* const ends[] = {all.low, all.high};
    float entries[8];
    return entered([&](unsigned end, unsigned a) { return Float8(ends[end][a]); }, entries) != 0;
  }

  /// Returns the slots of a node that the ray enters, one bit per slot, and lower bounds of the
  /// entries.
  unsigned entered(const OpenedNode& node, float (&entries)[kMaxSlots]) const {
    const float(*const ends[])[kMaxSlots] = {node.low, node.high};
    return entered([&](unsigned end, unsigned a) { return load8(ends[end][a]); }, entries);
  }

 private:
  /// `bound(end, a)` returns the low bounds on axis `a` for end 0, and the high bounds for end 1.
  /// The near end is looked up, because a branch would be mispredicted half the time.
  template <typename Bound>
  [[gnu::always_inline]] unsigned entered(const Bound& bound, float (&entries)[8]) const {
    Float8 entry(first_), exit(last_);
    for (unsigned a = 0; a < 3; ++a) {
      const Axis& axis = axes_[a];
      const Float8 reciprocal(axis.reciprocal);
      entry = max(entry, (bound(axis.near_end, a) - Float8(axis.origin_of_near)) * reciprocal);
      exit = min(exit, (bound(1 - axis.near_end, a) - Float8(axis.origin_of_far)) * reciprocal);
    }
    entry.store(entries);
    return (entry <= exit).bits();
  }

  struct Axis {
    float origin_of_near, origin_of_far, reciprocal;
    unsigned near_end;  // 0: low, 1: high
  };

  static double larger(double a, double b) {
    return std::fabs(a) < std::fabs(b) ? std::fabs(b) : std::fabs(a);
  }
  static double largest(const double (&v)[3]) { return larger(larger(v[0], v[1]), v[2]); }

  /// Returns the largest power of two that is at most `value`, which is positive and normal.
  static double power_of_two(double value) {
    std::uint64_t bits;
    std::memcpy(&bits, &value, sizeof bits);
    bits &= std::uint64_t{0x7FF} << 52;
    std::memcpy(&value, &bits, sizeof bits);
    return value;
  }

  static Axis make_axis(double origin, double direction, double reach, double farthest) {
    const double margin = 0x1p-21 * reach + 0x1p-60 * farthest + 0x1p-140;
    const bool is_backward = direction < 0, is_flat = std::fabs(direction) < 0x1p-126;
    const double reciprocal = is_flat ? (is_backward ? -0x1p126 : 0x1p126) : 1 / direction;
    const auto below = static_cast<float>(origin - margin);
    const auto above = static_cast<float>(origin + margin);
    return {is_backward ? below : above, is_backward ? above : below,
            static_cast<float>(reciprocal), is_backward ? 1u : 0u};
  }

  /// Returns a bound of t, moved in the direction of `sign` by more than the rounding of t.
  float scaled(float t, double sign) const {
    const double wide = (double{t} + sign * 0x1p-149) * scale_;
    return static_cast<float>(wide + sign * (std::fabs(wide) * 0x1p-22 + 0x1p-140));
  }

  Axis axes_[3];
  double scale_;
  float first_, last_;
};

// Eight triangles at once. Decides a triangle only if rounding cannot have
// changed a sign.
//
// Let z be the axis of the largest component of the direction, and s the two slopes d_x / d_z and
// d_y / d_z, which are at most 1. A shear by s makes the line parallel to z. A vertex p then has
// the coordinates
//     X = (p_x - o_x) - s_x (p_z - o_z),  and Y likewise,
// and an edge from p to q passes the line on the side of X_p Y_q - Y_p X_q, which is the
// determinant of ray_triangle.cpp over d_z (Woop, Benthin & Wald 2013, "Watertight ray/triangle
// intersection"; exactness comes from ray_triangle.cpp). If two edges certainly pass on different
// sides, the line misses the triangle. If all edges certainly pass on one side, the line hits the
// triangle away from its edges.
//
// Rounding, with u = 2^-24. Let L be the largest computed |p - o| on any axis and W the largest
// |X| or |Y|. The error of X is 6 u L: 2 u L from the first difference and the rounding of X
// itself, and 4 u L from the second difference, the slope, the product and the sum. The two
// products of an edge have this error twice each. With roundings of 4 u W^2, W <= 2 L and terms of
// second order, the error of the edge is at most
//     24.1 u L W + 73 u^2 L^2 + 4.1 u W^2 <= 40 u L (W + 4 u L).
// Underflow adds 2^-150 to X or to an edge. This is negligible if L is 2^-120 or more; otherwise
// 2^-84 covers it. Products are at most 2 L W. If 40 L W overflows before it is multiplied by u,
// the bound is infinite or NaN, and nothing is certain.

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

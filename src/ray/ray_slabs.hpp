#pragma once

/// Conservative test of a ray against eight boxes at a time: a box is entered if any point of the
/// ray within the box of all vertices might be inside it.
///
/// The direction is divided by a power of two so that its largest component is at least 1 and below
/// 2; here, t is the ray's t times this power. On an axis with direction d > 0, the box spans t
/// from (low - o) / d to (high - o) / d. Move o by a margin m, up for the first and down for the
/// second. Three roundings and those of o + m then increase the first to at most (low - o) / d if
///     m >= 4.1 2^-24 (|low| + |o| + m).
/// The coordinates of a point of the ray that counts are at most B, the bound of the box of all
/// vertices, and the rounded quotient increases with `low`, so |low| counts at most as B. This
/// gives m = 2^-21 (B + |o|). If |d| is below 2^-126 or zero, the reciprocal 2^126 replaces it, as
/// if the direction were changed by 2^-126: t is at most T = max B + max |o| over the axes, so the
/// ray moves by less than 2^-125 T, and in the box a t of T is reached within 2^-126 T. 2^-60 T,
/// added to m, covers both, and 2^-140 covers underflow. Nothing becomes NaN: reciprocals are
/// finite and not zero, and o is finite.

#include <pelt/ray.hpp>

#include "pose/pose_boxes.hpp"
#include "pose/posed_tree.hpp"
#include "query/slots.hpp"

#include <cmath>
#include <cstdint>
#include <cstring>

namespace pelt::detail {
inline namespace PELT_INSTRUCTION_SET {

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

}  // namespace PELT_INSTRUCTION_SET
}  // namespace pelt::detail

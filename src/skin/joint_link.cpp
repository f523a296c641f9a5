#include "skin/joint_link.hpp"

#include "base/float4.hpp"
#include "skin/dual_skin.hpp"

#include <cmath>
#include <cstddef>

namespace pelt::detail {
namespace {

/// The vector part of a b*.
Float4 turn_between(const Float4& a, const Float4& b) {
  return Float4(b[3]) * a - Float4(a[3]) * b - cross(a, b);
}

}  // namespace

LinkMotion motion_of(const JointLink& link, const MovedJoint& first, const MovedJoint& second,
                     float growth, float slack) {
  const Float4 a = load4(first.dual.real), b = load4(second.dual.real);
  // The dot product of the definition, so that its sign is the same.
  const float cosine = dot(dual_of(first.dual), dual_of(second.dual));
  const float magnitude = std::fabs(cosine);
  const Float4 turn = Float4(cosine < 0 ? -1.0f : 1.0f) * turn_between(a, b);
  const float squared = 2 * (1 - magnitude) + kCosineRounding;

  const auto column = [&](std::size_t i) {
    return load4(&first.matrix.m[4 * i]) - load4(&second.matrix.m[4 * i]);
  };
  const Float4 x = column(0), y = column(1), z = column(2);
  const Float4 way = (Float4(link.centre[0]) * x + Float4(link.centre[1]) * y) +
                     (Float4(link.centre[2]) * z + column(3));
  const Float4 reach = Float4(link.half[0] + growth) * abs(x) +
                       Float4(link.half[1] + growth) * abs(y) +
                       Float4(link.half[2] + growth) * abs(z);
  const Float4 rounding(slack);
  LinkMotion motion;
  const Float4 middle = cross(way, turn), half = cross_magnitude(reach, abs(turn)) + rounding;
  store4(motion.low, middle - half);
  store4(motion.high, middle + half);
  store4(motion.swell, Float4(std::sqrt(squared)) * (abs(way) + reach + rounding));
  store4(motion.turn, turn);
  motion.low[3] = 0, motion.high[3] = squared, motion.swell[3] = magnitude, motion.turn[3] = cosine;
  return motion;
}

}  // namespace pelt::detail

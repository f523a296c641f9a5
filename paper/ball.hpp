#pragma once

#include "base/float4.hpp"
#include "paper/sphere.hpp"

namespace pelt::paper {

using detail::Float4;

/// A ball for the descent: lanes x, y, z are the centre, lane 3 is the radius.
///
/// The radius has room for the rounding of balls_meet and of the norms that it was made by, and
/// enough of it that its square does not underflow.
inline Float4 make_ball(const Float4& centre, float radius) {
  return {centre[0], centre[1], centre[2], radius * (1 + 0x1p-20f) + 0x1p-60f};
}

inline Float4 make_ball(const Sphere& sphere) {
  return make_ball({sphere.centre.x, sphere.centre.y, sphere.centre.z, 0}, sphere.radius);
}

inline float squared_distance(const Float4& a, const Float4& b) {
  const Float4 d = a - b;
  const Float4 dd = d * d;
  return (dd[0] + dd[1]) + dd[2];
}

/// Whether two balls intersect. Never false for balls whose real radii touch.
inline bool balls_meet(const Float4& a, const Float4& b) {
  const float radii = a[3] + b[3];
  return squared_distance(a, b) <= radii * radii;
}

/// Four balls side by side: lane i is ball i.
struct Balls4 {
  Float4 x, y, z, radius;
};

inline Balls4 balls_side_by_side(Float4 b0, Float4 b1, Float4 b2, Float4 b3) {
  detail::transpose(b0, b1, b2, b3);
  return {b0, b1, b2, b3};
}

/// The bits of squared_distance in each lane.
inline Float4 squared_distances(const Balls4& balls, const Float4& centre) {
  const Float4 x = balls.x - Float4(centre[0]), y = balls.y - Float4(centre[1]);
  const Float4 z = balls.z - Float4(centre[2]);
  return (x * x + y * y) + z * z;
}

/// Positive in the lanes of the balls that do not intersect `other`, as by balls_meet.
inline Float4 gaps_between(const Balls4& balls, const Float4& other) {
  const Float4 radii = balls.radius + Float4(other[3]);
  return squared_distances(balls, other) - radii * radii;
}

}  // namespace pelt::paper

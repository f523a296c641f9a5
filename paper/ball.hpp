#pragma once

#include "base/float4.hpp"
#include "geometry/sphere.hpp"

namespace pelt::paper {

using detail::Float4;

/// A ball for the descent: lanes x, y, z are the centre, lane 3 is the radius.
///
/// The radius has room for the rounding of balls_meet and of the norms that it was made by, and
/// enough of it that its square does not underflow.
inline Float4 make_ball(const Float4& centre, float radius) {
  return {centre[0], centre[1], centre[2], radius * (1 + 0x1p-20f) + 0x1p-60f};
}

inline Float4 make_ball(const detail::Sphere& sphere) {
  return make_ball({sphere.centre.x, sphere.centre.y, sphere.centre.z, 0}, sphere.radius);
}

inline float squared_distance(const Float4& a, const Float4& b) {
  const Float4 d = a - b;
  const Float4 dd = d * d;
  return (dd[0] + dd[1]) + dd[2];
}

/// Whether two balls meet; balls that touch by their real radii are never said to be apart.
inline bool balls_meet(const Float4& a, const Float4& b) {
  const float radii = a[3] + b[3];
  return squared_distance(a, b) <= radii * radii;
}

}  // namespace pelt::paper

#pragma once

#include "base/float4.hpp"

#include <array>

namespace pelt::paper {

using detail::Float4;

/// Four points side by side: lane i of x, y and z is point i.
struct Points4 {
  Float4 x, y, z;
};

inline Points4 operator-(const Points4& p, const Points4& q) {
  return {p.x - q.x, p.y - q.y, p.z - q.z};
}
inline Points4 operator+(const Points4& p, const Points4& q) {
  return {p.x + q.x, p.y + q.y, p.z + q.z};
}
inline Points4 operator*(const Float4& s, const Points4& p) { return {s * p.x, s * p.y, s * p.z}; }
inline Float4 dot(const Points4& p, const Points4& q) { return p.x * q.x + p.y * q.y + p.z * q.z; }

/// Transposes four points with coordinates in lanes 0 to 2.
inline Points4 side_by_side(Float4 p0, Float4 p1, Float4 p2, Float4 p3) {
  detail::transpose(p0, p1, p2, p3);
  return {p0, p1, p2};
}

/// The minimal balls of four triangles up to rounding, which goes into the radius: around the
/// circumcentre a + s ab + t ac or, where a corner has no acute angle, the middle of the side
/// across from it.
inline std::array<Float4, 4> triangle_balls(const Points4& a, const Points4& b, const Points4& c) {
  const Points4 ab = b - a, ac = c - a;
  const Float4 ab2 = dot(ab, ab), ac2 = dot(ac, ac), cos_a = dot(ab, ac);
  const Float4 cos_b = ab2 - cos_a, cos_c = ac2 - cos_a;
  const Float4 zero(0.0f), half(0.5f), scale = half / (ab2 * ac2 - cos_a * cos_a);
  // An acute triangle has s and t in (0, 1/2); written so that NaN becomes 0.
  Float4 s = scale * ac2 * cos_b, t = scale * ab2 * cos_c;
  s = if_positive(s, min(s, half), zero);
  t = if_positive(t, min(t, half), zero);
  s = if_positive(cos_c, if_positive(cos_b, if_positive(cos_a, s, half), zero), half);
  t = if_positive(cos_c, if_positive(cos_b, if_positive(cos_a, t, half), half), zero);
  const Points4 centre = a + (s * ab + t * ac);
  const Points4 from_a = a - centre, from_b = b - centre, from_c = c - centre;
  const Float4 squared_radius =
      max(max(dot(from_a, from_a), dot(from_b, from_b)), dot(from_c, from_c));
  std::array<Float4, 4> balls = {centre.x, centre.y, centre.z, sqrt(squared_radius)};
  detail::transpose(balls[0], balls[1], balls[2], balls[3]);
  return balls;
}

}  // namespace pelt::paper

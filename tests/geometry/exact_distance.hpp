#pragma once

/// Squared distances in rational numbers, as the least over features: an oracle that rounds once.

#include "geometry/triangle_pair.hpp"

#include <gmpxx.h>

#include <algorithm>
#include <array>

namespace pelt::test {

using ExactVector = std::array<mpq_class, 3>;

inline ExactVector exact(const Vec3& p) {
  return {mpq_class(double{p.x}), mpq_class(double{p.y}), mpq_class(double{p.z})};
}
inline ExactVector operator-(const ExactVector& a, const ExactVector& b) {
  return {mpq_class(a[0] - b[0]), mpq_class(a[1] - b[1]), mpq_class(a[2] - b[2])};
}
inline ExactVector along(const ExactVector& p, const mpq_class& s, const ExactVector& v) {
  return {mpq_class(p[0] + s * v[0]), mpq_class(p[1] + s * v[1]), mpq_class(p[2] + s * v[2])};
}
inline mpq_class dot(const ExactVector& a, const ExactVector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline mpq_class squared(const ExactVector& v) { return dot(v, v); }

inline mpq_class point_segment(const ExactVector& p, const ExactVector& a, const ExactVector& b) {
  const ExactVector ab = b - a;
  const mpq_class length = squared(ab);
  mpq_class s = length == 0 ? mpq_class(0) : mpq_class(dot(p - a, ab) / length);
  s = std::clamp(s, mpq_class(0), mpq_class(1));
  return squared(p - along(a, s, ab));
}

/// Uses the normal equations if the closest points of the two lines are inside both segments,
/// otherwise the distances of the ends.
inline mpq_class segment_segment(const ExactVector& a, const ExactVector& b, const ExactVector& c,
                                 const ExactVector& d) {
  mpq_class least = std::min({point_segment(a, c, d), point_segment(b, c, d),
                              point_segment(c, a, b), point_segment(d, a, b)});
  const ExactVector u = b - a, v = d - c, w = a - c;
  const mpq_class uu = squared(u), vv = squared(v), uv = dot(u, v);
  const mpq_class divisor = uu * vv - uv * uv;
  if (divisor == 0) return least;
  const mpq_class s = (uv * dot(v, w) - dot(u, w) * vv) / divisor;
  const mpq_class t = (uu * dot(v, w) - uv * dot(u, w)) / divisor;
  if (s < 0 || s > 1 || t < 0 || t > 1) return least;
  return std::min(least, squared(along(a, s, u) - along(c, t, v)));
}

using ExactTriangle = std::array<ExactVector, 3>;

inline ExactTriangle exact(const detail::TriangleCorners& t) {
  return {exact(t[0]), exact(t[1]), exact(t[2])};
}

inline mpq_class point_triangle(const ExactVector& p, const ExactTriangle& t) {
  mpq_class least = std::min(
      {point_segment(p, t[0], t[1]), point_segment(p, t[1], t[2]), point_segment(p, t[2], t[0])});
  const ExactVector u = t[1] - t[0], v = t[2] - t[0], w = p - t[0];
  const mpq_class uu = squared(u), vv = squared(v), uv = dot(u, v);
  const mpq_class divisor = uu * vv - uv * uv;
  if (divisor == 0) return least;
  const mpq_class s = (vv * dot(w, u) - uv * dot(w, v)) / divisor;
  const mpq_class r = (uu * dot(w, v) - uv * dot(w, u)) / divisor;
  if (s < 0 || r < 0 || s + r > 1) return least;
  return std::min(least, squared(p - along(along(t[0], s, u), r, v)));
}

/// Precondition: the triangles do not touch.
inline mpq_class triangle_triangle(const ExactTriangle& a, const ExactTriangle& b) {
  mpq_class least = squared(a[0] - b[0]);
  for (std::size_t i = 0; i < 3; ++i) {
    least = std::min({least, point_triangle(a[i], b), point_triangle(b[i], a)});
    for (std::size_t j = 0; j < 3; ++j)
      least = std::min(least, segment_segment(a[i], a[(i + 1) % 3], b[j], b[(j + 1) % 3]));
  }
  return least;
}

/// The square root of a rational number, rounded to about 100 bits and then to double.
inline double root(const mpq_class& value) {
  return mpf_class(sqrt(mpf_class(value, 256))).get_d();
}

}  // namespace pelt::test

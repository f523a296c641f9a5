/// The minimal enclosing sphere by pivoting on the farthest point (Gaertner, "Fast and robust
/// smallest enclosing balls", ESA 1999). The sphere is the minimal sphere of at most four of the
/// points, its support. While a point is outside the current sphere, the farthest such point joins
/// the support, and the minimal sphere of these at most five points, which has a larger radius,
/// replaces the current one.
///
/// The small problem is solved by trying the circumcentre of every subset with the new point. The
/// centre is the candidate with the least distance to its farthest point, so candidates are
/// compared by this distance. No tolerance is needed: a circumcentre that is far off because its
/// points are nearly dependent loses the comparison.
#include "paper/min_sphere.hpp"

#include "base/assert.hpp"
#include "base/vec3.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

namespace pelt::paper {
namespace {

using detail::cross;
using detail::dot;
using detail::squared_length;
using detail::to_float;
using detail::Vec3d;

/// Points on the boundary of a sphere: at most four, or five while the sphere is being enlarged.
struct Support {
  std::array<Vec3d, 5> points;
  std::size_t count = 0;
};

/// A sphere and those of its points that determine it.
struct SupportedSphere {
  Support support;
  Vec3d centre;
  double squared_radius = 0;
};

double squared_distance(const Vec3d& a, const Vec3d& b) { return squared_length(a - b); }

/// The point in the plane of 0, u and v with equal distances from 0, u and v. Here and below, a
/// divisor is zero or at least 2^-596, so that even a useless quotient is not NaN.
std::optional<Vec3d> circumcentre(const Vec3d& u, const Vec3d& v) {
  const Vec3d normal = cross(u, v);
  const double divisor = 2 * squared_length(normal);
  if (divisor == 0) return std::nullopt;
  const Vec3d across = squared_length(u) * v - squared_length(v) * u;
  return (1 / divisor) * cross(across, normal);
}

/// The point with equal distances from 0, u, v and w.
std::optional<Vec3d> circumcentre(const Vec3d& u, const Vec3d& v, const Vec3d& w) {
  const Vec3d vw = cross(v, w);
  const double divisor = 2 * dot(u, vw);
  if (divisor == 0) return std::nullopt;
  const Vec3d sum =
      squared_length(u) * vw + squared_length(v) * cross(w, u) + squared_length(w) * cross(u, v);
  return (1 / divisor) * sum;
}

std::optional<Vec3d> circumcentre(const Support& s) {
  const Vec3d& p = s.points[0];
  std::optional<Vec3d> offset = Vec3d();
  if (s.count == 2) offset = 0.5 * (s.points[1] - p);
  if (s.count == 3) offset = circumcentre(s.points[1] - p, s.points[2] - p);
  if (s.count == 4) offset = circumcentre(s.points[1] - p, s.points[2] - p, s.points[3] - p);
  if (!offset) return std::nullopt;
  return p + *offset;
}

double farthest_squared_distance(const Vec3d& centre, const Support& s) {
  double farthest = 0;
  for (std::size_t i = 0; i < s.count; ++i) {
    farthest = std::max(farthest, squared_distance(centre, s.points[i]));
  }
  return farthest;
}

/// The members of `s` whose bits are set in `subset`.
Support choose(const Support& s, unsigned subset) {
  Support chosen;
  for (std::size_t i = 0; i < s.count; ++i) {
    if (subset >> i & 1) chosen.points[chosen.count++] = s.points[i];
  }
  return chosen;
}

/// The minimal sphere of a support's points. Its boundary contains the last point.
SupportedSphere min_sphere_through_last(const Support& s) {
  SupportedSphere best;
  best.squared_radius = std::numeric_limits<double>::infinity();
  const unsigned last = 1u << (s.count - 1);
  for (unsigned others = 0; others < last; ++others) {
    const Support chosen = choose(s, others | last);
    if (chosen.count > 4) continue;
    const std::optional<Vec3d> centre = circumcentre(chosen);
    if (!centre) continue;
    const double squared_radius = farthest_squared_distance(*centre, s);
    if (squared_radius < best.squared_radius) best = {chosen, *centre, squared_radius};
  }
  return best;
}

Vec3d farthest_point(const Vec3d& centre, std::span<const Vec3> points) {
  double farthest = -1;
  std::size_t index = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double d = squared_distance(Vec3d(points[i]), centre);
    if (d > farthest) farthest = d, index = i;
  }
  return Vec3d(points[index]);
}

/// The centre of the minimal sphere, up to rounding. The radius grows in every round, so no support
/// comes twice and the loop ends.
Vec3d min_sphere_centre(std::span<const Vec3> points) {
  SupportedSphere current;
  current.support.points[0] = current.centre = Vec3d(points[0]);
  current.support.count = 1;
  while (true) {
    const Vec3d pivot = farthest_point(current.centre, points);
    if (squared_distance(pivot, current.centre) <= current.squared_radius) break;
    Support grown = current.support;
    grown.points[grown.count++] = pivot;
    const SupportedSphere next = min_sphere_through_last(grown);
    if (next.squared_radius <= current.squared_radius) break;
    current = next;
  }
  return current.centre;
}

/// The sphere around `centre`, rounded to float, that encloses all points. The last line rounds up:
/// 2^-23 covers the rounding to a normal float, 2^-24, and that of the distance, less than 2^-50;
/// 2^-149 covers the rounding to a subnormal one.
Sphere enclose(const Vec3d& centre, std::span<const Vec3> points) {
  const Vec3 rounded = to_float(centre);
  double farthest = 0;
  for (const Vec3& p : points) {
    farthest = std::max(farthest, squared_distance(Vec3d(p), Vec3d(rounded)));
  }
  return {rounded, static_cast<float>(std::sqrt(farthest) * (1 + 0x1p-23) + 0x1p-149)};
}

}  // namespace

Sphere min_sphere(std::span<const Vec3> points) {
  PELT_ASSERT(!points.empty());
  return enclose(min_sphere_centre(points), points);
}

}  // namespace pelt::paper

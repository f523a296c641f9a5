#pragma once

/// Distances by brute force over all pairs of posed triangles.

#include "geometry/triangle_distance.hpp"
#include "support/brute_force.hpp"

#include <pelt/distance.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

namespace pelt::test {

using detail::closest_points;
using detail::TriangleCorners;
using detail::triangles_intersect;

inline double triangle_distance(const TriangleCorners& a, const TriangleCorners& b) {
  return triangles_intersect(a, b) ? 0 : std::sqrt(closest_points(a, b).squared_distance);
}

struct BruteDistance {
  double distance = std::numeric_limits<double>::infinity();
  std::uint32_t triangle_a = 0, triangle_b = 0;
};

/// The gap of two boxes on an axis, in double.
inline double axis_gap(const TriangleCorners& a, const TriangleCorners& b, float Vec3::*axis) {
  const auto low = [&](const TriangleCorners& t) {
    return double{std::min({t[0].*axis, t[1].*axis, t[2].*axis})};
  };
  const auto high = [&](const TriangleCorners& t) {
    return double{std::max({t[0].*axis, t[1].*axis, t[2].*axis})};
  };
  return std::max({low(a) - high(b), low(b) - high(a), 0.0});
}

inline double box_gap(const TriangleCorners& a, const TriangleCorners& b) {
  const double x = axis_gap(a, b, &Vec3::x), y = axis_gap(a, b, &Vec3::y);
  const double z = axis_gap(a, b, &Vec3::z);
  return std::sqrt(x * x + y * y + z * z);
}

/// The least distance; among equal ones, the lowest pair.
inline BruteDistance brute_distance(std::span<const TriangleCorners> a,
                                    std::span<const TriangleCorners> b) {
  BruteDistance best;
  double best_squared = best.distance;
  for (std::uint32_t i = 0; i < a.size(); ++i)
    for (std::uint32_t j = 0; j < b.size(); ++j) {
      if (box_gap(a[i], b[j]) > best.distance * (1 + 1e-6) + 1e-30) continue;
      const double squared =
          triangles_intersect(a[i], b[j]) ? 0 : closest_points(a[i], b[j]).squared_distance;
      if (!(squared < best_squared)) continue;
      best_squared = squared;
      best = {std::sqrt(squared), i, j};
    }
  return best;
}

/// All pairs within a distance, in ascending order.
inline std::vector<Contact> brute_clearance(std::span<const TriangleCorners> a,
                                            std::span<const TriangleCorners> b, double tolerance) {
  std::vector<Contact> pairs;
  for (std::uint32_t i = 0; i < a.size(); ++i)
    for (std::uint32_t j = 0; j < b.size(); ++j)
      if (box_gap(a[i], b[j]) <= tolerance * (1 + 1e-6) &&
          triangle_distance(a[i], b[j]) <= tolerance)
        pairs.push_back({i, j});
  return pairs;
}

/// Compares two answers bit by bit.
inline bool same(const Distance& x, const Distance& y) {
  const auto same_point = [](const SurfacePoint& p, const SurfacePoint& q) {
    return p.triangle == q.triangle && p.barycentrics == q.barycentrics && p.position == q.position;
  };
  return x.distance == y.distance && x.lower_bound == y.lower_bound && same_point(x.a, y.a) &&
         same_point(x.b, y.b);
}

}  // namespace pelt::test

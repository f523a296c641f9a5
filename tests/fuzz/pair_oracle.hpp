#pragma once

/// All pairs of triangles of two bodies, one by one.

#include "fuzz/fuzzed_bodies.hpp"
#include "geometry/triangle_distance.hpp"
#include "geometry/triangle_pair.hpp"

#include <pelt/collide.hpp>

#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace pelt::test {

inline double squared_distance_of(const detail::TriangleCorners& a,
                                  const detail::TriangleCorners& b) {
  return detail::triangles_intersect(a, b) ? 0 : detail::closest_points(a, b).squared_distance;
}

inline double distance_of(const detail::TriangleCorners& a, const detail::TriangleCorners& b) {
  return std::sqrt(squared_distance_of(a, b));
}

inline std::vector<Contact> intersecting_pairs(std::span<const detail::TriangleCorners> a,
                                               std::span<const detail::TriangleCorners> b) {
  std::vector<Contact> pairs;
  for (std::uint32_t i = 0; i < a.size(); ++i)
    for (std::uint32_t j = 0; j < b.size(); ++j)
      if (detail::triangles_intersect(a[i], b[j])) pairs.push_back({i, j});
  return pairs;
}

struct LeastDistance {
  double distance = std::numeric_limits<double>::infinity();
  std::uint32_t triangle_a = 0, triangle_b = 0;
};

/// The least distance; of several pairs with this distance, the lowest.
inline LeastDistance least_distance(std::span<const detail::TriangleCorners> a,
                                    std::span<const detail::TriangleCorners> b) {
  LeastDistance least;
  double least_squared = least.distance;
  for (std::uint32_t i = 0; i < a.size(); ++i)
    for (std::uint32_t j = 0; j < b.size(); ++j) {
      const double squared = squared_distance_of(a[i], b[j]);
      if (!(squared < least_squared)) continue;
      least_squared = squared;
      least = {std::sqrt(squared), i, j};
    }
  return least;
}

}  // namespace pelt::test

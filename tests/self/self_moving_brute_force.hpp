#pragma once

/// The contacts of a moving character with itself, by a test of all pairs.

#include "collide/moving_brute_force.hpp"
#include "self/neighbours.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <vector>

namespace pelt::test {

using SurfaceCornersOfAll = std::vector<std::array<std::uint32_t, 3>>;

inline SurfaceCornersOfAll surface_corners(std::span<const Triangle> triangles,
                                           const std::vector<std::uint32_t>& surface) {
  SurfaceCornersOfAll corners;
  for (const Triangle& t : triangles)
    corners.push_back({surface[t[0]], surface[t[1]], surface[t[2]]});
  return corners;
}

inline bool share_vertex(const std::array<std::uint32_t, 3>& a,
                         const std::array<std::uint32_t, 3>& b) {
  return std::any_of(a.begin(), a.end(),
                     [&](std::uint32_t v) { return std::count(b.begin(), b.end(), v) > 0; });
}

/// `with_filter`: uses the filter in double for neighbours, which tests/self compares with the
/// exact test.
inline std::vector<MovingContact> brute_force_self_moving(const MovingTriangles& triangles,
                                                          const SurfaceCornersOfAll& corners,
                                                          bool with_filter = false) {
  std::vector<MovingContact> contacts;
  const auto add = [&](std::uint32_t s, std::uint32_t t,
                       const std::optional<detail::FirstMeeting>& first) {
    if (first) contacts.push_back(contact_of(s, t, *first));
  };
  for (std::uint32_t s = 0; s < triangles.size(); ++s)
    for (std::uint32_t t = s + 1; t < triangles.size(); ++t) {
      if (are_far(triangles[s], triangles[t])) continue;
      const detail::MovingSurfaceTriangle a = {triangles[s], corners[s]};
      const detail::MovingSurfaceTriangle b = {triangles[t], corners[t]};
      if (!share_vertex(corners[s], corners[t]))
        add(s, t, first_meeting_of(triangles[s], triangles[t]));
      else if (!with_filter || !detail::certainly_apart(a, b))
        add(s, t, detail::first_meeting_of_neighbours(a, b));
    }
  return contacts;
}

}  // namespace pelt::test

#pragma once

/// The test of all pairs of moving triangles. It uses the filtered test, which tests/motion
/// compares with the exact one.

#include "motion/moving_filter.hpp"

#include <pelt/mesh.hpp>
#include <pelt/motion.hpp>

#include <algorithm>
#include <optional>
#include <span>
#include <vector>

namespace pelt::test {

using MovingTriangles = std::vector<detail::MovingTriangle>;

/// The triangles of a model between two of its poses.
inline MovingTriangles moving_triangles(std::span<const Triangle> triangles, const Pose& from,
                                        const Pose& to) {
  std::vector<Vec3> first(from.model().vertex_count()), last(first.size());
  posed_vertices(from, first);
  posed_vertices(to, last);
  MovingTriangles all;
  for (const auto& [p, q, r] : triangles)
    all.push_back({{first[p], first[q], first[r]}, {last[p], last[q], last[r]}});
  return all;
}

inline MovingContact contact_of(std::uint32_t a, std::uint32_t b,
                                const detail::FirstMeeting& first) {
  if (first.at_start) return {{a, b}, first.time, true, {}, {}};
  return {{a, b}, first.time, false, first.a, first.b};
}

/// Whether the boxes of the whole paths of two triangles are disjoint.
inline bool are_far(const detail::MovingTriangle& a, const detail::MovingTriangle& b) {
  for (float Vec3::*const axis : {&Vec3::x, &Vec3::y, &Vec3::z}) {
    const auto range = [&](const detail::MovingTriangle& t) {
      return std::minmax({t.from[0].*axis, t.from[1].*axis, t.from[2].*axis, t.to[0].*axis,
                          t.to[1].*axis, t.to[2].*axis});
    };
    if (range(a).second < range(b).first || range(b).second < range(a).first) return true;
  }
  return false;
}

inline std::optional<detail::FirstMeeting> first_meeting_of(const detail::MovingTriangle& a,
                                                            const detail::MovingTriangle& b) {
  MovingStats work;
  return detail::find_first_meeting(a, b, work);
}

inline std::vector<MovingContact> brute_force_moving(const MovingTriangles& a,
                                                     const MovingTriangles& b) {
  std::vector<MovingContact> contacts;
  for (std::uint32_t i = 0; i < a.size(); ++i)
    for (std::uint32_t k = 0; k < b.size(); ++k) {
      if (are_far(a[i], b[k])) continue;
      if (const auto first = first_meeting_of(a[i], b[k]))
        contacts.push_back(contact_of(i, k, *first));
    }
  return contacts;
}

}  // namespace pelt::test

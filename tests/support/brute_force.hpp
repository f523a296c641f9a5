#pragma once

/// The contacts of two posed meshes, by a test of all pairs of triangles.

#include "geometry/triangle_pair.hpp"

#include <pelt/collide.hpp>

#include <span>
#include <vector>

namespace pelt::test {

inline std::vector<Vec3> positions_of(const Pose& pose) {
  std::vector<Vec3> positions(pose.model().vertex_count());
  posed_vertices(pose, positions);
  return positions;
}

/// All triangles, posed.
inline std::vector<detail::TriangleCorners> posed_triangles(std::span<const Triangle> triangles,
                                                            const Pose& pose) {
  const std::vector<Vec3> positions = positions_of(pose);
  std::vector<detail::TriangleCorners> posed;
  for (const Triangle& t : triangles)
    posed.push_back({positions[t[0]], positions[t[1]], positions[t[2]]});
  return posed;
}

inline std::vector<Contact> brute_force(std::span<const Triangle> triangles_a, const Pose& pose_a,
                                        std::span<const Triangle> triangles_b, const Pose& pose_b) {
  const auto a = posed_triangles(triangles_a, pose_a), b = posed_triangles(triangles_b, pose_b);
  std::vector<Contact> contacts;
  for (std::uint32_t i = 0; i < a.size(); ++i)
    for (std::uint32_t k = 0; k < b.size(); ++k)
      if (detail::triangles_intersect(a[i], b[k])) contacts.push_back({i, k});
  return contacts;
}

}  // namespace pelt::test

#pragma once

/// The contacts of two posed meshes, by a test of all pairs of triangles.

#include <pelt/collide.hpp>

#include "geometry/triangle_pair.hpp"
#include "support/skinned_shapes.hpp"

#include <gtest/gtest.h>

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

// The contacts of two poses, by a query and by brute force.

inline std::vector<Contact> contacts_of(Pose& a, Pose& b, Scratch& scratch) {
  std::vector<Contact> contacts;
  collide(a, b, scratch, contacts);
  return contacts;
}

inline std::vector<Contact> brute_force(const Shape& a, const Pose& pose_a, const Shape& b,
                                        const Pose& pose_b) {
  return brute_force(a.triangles, pose_a, b.triangles, pose_b);
}

/// Two bending limbs, some of which touch.
struct LimbPair {
  Shape shape_a = make_limb(24, 10, 5), shape_b = make_limb(17, 9, 4);
  Pose a = Pose(*build_model(shape_a.view())), b = Pose(*build_model(shape_b.view()));
  Scratch scratch;

  void move(Random& random, double distance) {
    ASSERT_TRUE(a.set_palette(bend_limb(random, 5, random.uniform(-0.6, 0.6), {})));
    ASSERT_TRUE(
        b.set_palette(bend_limb(random, 4, random.uniform(-0.6, 0.6), random.point(distance))));
  }

  std::vector<detail::TriangleCorners> triangles_a() const {
    return posed_triangles(shape_a.triangles, a);
  }
  std::vector<detail::TriangleCorners> triangles_b() const {
    return posed_triangles(shape_b.triangles, b);
  }
};

}  // namespace pelt::test

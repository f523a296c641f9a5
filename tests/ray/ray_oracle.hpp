#pragma once

/// The oracle of ray casts: tests every posed triangle with the exact predicate, without a tree.

#include "geometry/ray_triangle.hpp"
#include "support/values.hpp"

#include <pelt/mesh.hpp>
#include <pelt/ray.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <span>
#include <vector>

namespace pelt::test {

class RayOracle {
 public:
  RayOracle(std::span<const Triangle> triangles, const Pose& pose)
      : triangles_(triangles), positions_(pose.model().vertex_count()) {
    posed_vertices(pose, positions_);
  }

  const std::vector<Vec3>& positions() const { return positions_; }

  detail::TriangleCorners corners(std::uint32_t triangle) const {
    const auto [a, b, c] = triangles_[triangle];
    return {positions_[a], positions_[b], positions_[c]};
  }

  /// All hits in ascending order of t, then of the triangle. Does not set `location`.
  std::vector<RayHit> all(const Ray& ray, Facing facing = Facing::both) const {
    std::vector<RayHit> hits;
    const detail::RayLine line = {ray.origin, ray.direction};
    for (std::uint32_t i = 0; i < triangles_.size(); ++i) {
      detail::RayCrossing crossing;
      if (!detail::line_meets_triangle(line, corners(i), crossing)) continue;
      if (crossing.t < ray.t_min || crossing.t > ray.t_max) continue;
      if (facing != Facing::both && crossing.from_front != (facing == Facing::front)) continue;
      hits.push_back({i,
                      {},
                      crossing.t,
                      detail::crossing_weights(line, corners(i), crossing),
                      detail::unit_normal(corners(i))});
    }
    std::stable_sort(hits.begin(), hits.end(),
                     [](const RayHit& a, const RayHit& b) { return a.t < b.t; });
    return hits;
  }

 private:
  std::span<const Triangle> triangles_;
  std::vector<Vec3> positions_;
};

inline RayHit without_location(RayHit hit) {
  hit.location = {};
  return hit;
}

/// Compares all queries of a ray with the oracle; a failure names the ray. Returns the number of
/// triangles that the ray hits.
inline std::size_t expect_as_oracle(Pose& pose, const RayOracle& oracle, const Ray& ray,
                                    Scratch& scratch, Facing facing = Facing::both) {
  const std::vector<RayHit> expected = oracle.all(ray, facing);
  const RayHit first = test::first_hit(pose, ray, facing);
  EXPECT_EQ(without_location(first), expected.empty() ? RayHit() : expected[0]);
  bool any = false;
  cast_any(pose, std::span(&ray, 1), std::span(&any, 1), facing);
  EXPECT_EQ(any, !expected.empty());
  std::vector<RayHit> all;
  cast_all(pose, ray, scratch, all, facing);
  std::transform(all.begin(), all.end(), all.begin(), without_location);
  EXPECT_EQ(all, expected);
  return expected.size();
}

}  // namespace pelt::test

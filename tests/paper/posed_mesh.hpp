#pragma once

/// Shared by the tests of refitted spheres: valid meshes and palettes, and the posed vertices that
/// a sphere has to enclose.

#include "base/vec3.hpp"
#include "paper/refit.hpp"
#include "skin/skin.hpp"
#include "support/skinned_shapes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace pelt::test {

inline detail::SkinnedMesh checked_mesh(const Shape& shape) {
  BuildReport report;
  auto mesh = detail::make_skinned_mesh(shape.view(), {}, report);
  EXPECT_TRUE(mesh) << mesh.error().message;
  return *std::move(mesh);
}

inline detail::Palette checked_palette(const detail::SkinnedMesh& mesh,
                                       const std::vector<Matrix4>& joints) {
  detail::Palette palette(mesh.joint_count, mesh.rest_extent);
  const Result<void> taken = palette.set(joints);
  EXPECT_TRUE(taken);
  return palette;
}

/// Each vertex of a node's triangles once.
inline std::vector<std::uint32_t> vertices_below(const detail::SkinnedMesh& mesh,
                                                 const paper::SphereTree& tree,
                                                 const paper::Node& node) {
  std::vector<std::uint32_t> vertices;
  for (const std::uint32_t t : tree.triangles_of(node))
    vertices.insert(vertices.end(), mesh.triangles[t].begin(), mesh.triangles[t].end());
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

/// |v - c| / r in double; at most 1 for an enclosed vertex.
inline double relative_reach(const detail::Float4& sphere, const Vec3& v) {
  const detail::Vec3d centre(sphere[0], sphere[1], sphere[2]);
  return std::sqrt(detail::squared_length(detail::Vec3d(v) - centre)) /
         static_cast<double>(sphere[3]);
}

/// The excess over the real radius that rounding may cause in a refitted radius.
inline double rounding_room(const paper::SphereModel& model, const detail::Palette& palette,
                            double radius) {
  const double margin =
      (4.0 * model.bounds.max_joints + 32) * 0x1p-24 * static_cast<double>(palette.reach());
  return 2 * margin + 0x1p-18 * radius;
}

}  // namespace pelt::test

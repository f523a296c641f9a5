#pragma once

/// Valid meshes from the shapes of tests/support.

#include "skin/skinned_mesh.hpp"
#include "support/skinned_shapes.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace pelt::test {

inline detail::SkinnedMesh mesh_of(const Shape& shape) {
  BuildReport report;
  auto mesh = detail::make_skinned_mesh(shape.view(), {}, report);
  EXPECT_TRUE(mesh) << (mesh ? "" : mesh.error().message);
  return *std::move(mesh);
}

/// Appends a copy of vertex `v` and returns its number.
inline std::uint32_t split_vertex(Shape& shape, std::uint32_t v) {
  const std::uint32_t k = shape.influences_per_vertex;
  shape.rest_positions.push_back(Vec3(shape.rest_positions[v]));
  for (std::uint32_t i = v * k; i < (v + 1) * k; ++i) {
    shape.joints.push_back(std::uint16_t{shape.joints[i]});
    shape.weights.push_back(float{shape.weights[i]});
  }
  return static_cast<std::uint32_t>(shape.rest_positions.size() - 1);
}

/// Splits vertices as exporters do at seams: each corner of a triangle gets a vertex of its own
/// with the given probability.
inline void split_at_seams(Shape& shape, Random& random, double probability) {
  for (Triangle& triangle : shape.triangles)
    for (std::uint32_t& v : triangle)
      if (random.chance(probability)) v = split_vertex(shape, v);
}

/// Sample poses that consist of the rest pose only.
inline std::vector<std::vector<Vec3>> rest_only(const detail::SkinnedMesh& mesh) {
  return {mesh.rest_positions};
}

}  // namespace pelt::test

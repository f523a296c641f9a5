#include "support/pinned_shapes.hpp"

namespace pelt::test {

Shape make_pinned(std::uint32_t vertex_count, const std::vector<Triangle>& triangles) {
  Shape shape;
  for (std::uint32_t v = 0; v < vertex_count; ++v) {
    const auto turn = static_cast<float>(v % 8) * 0.125f, way = static_cast<float>(v) * 0.01f;
    shape.rest_positions.push_back({turn, turn * (1 - turn), way});
    shape.joints.push_back(static_cast<std::uint16_t>(v));
    shape.weights.push_back(1);
  }
  shape.triangles = triangles;
  shape.influences_per_vertex = 1;
  shape.joint_count = vertex_count;
  return shape;
}

std::vector<Matrix4> pin(std::span<const Vec3> positions) {
  std::vector<Matrix4> palette(positions.size());
  for (std::size_t i = 0; i < positions.size(); ++i) {
    palette[i].m[0] = palette[i].m[5] = palette[i].m[10] = 0;
    palette[i].m[12] = positions[i].x;
    palette[i].m[13] = positions[i].y;
    palette[i].m[14] = positions[i].z;
  }
  return palette;
}

std::vector<Triangle> tetrahedron() { return {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}}; }

std::vector<Triangle> octahedron() {
  return {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
}

std::vector<Triangle> torus(std::uint32_t rings, std::uint32_t sides) {
  std::vector<Triangle> triangles;
  const auto at = [&](std::uint32_t ring, std::uint32_t side) {
    return ring % rings * sides + side % sides;
  };
  for (std::uint32_t r = 0; r < rings; ++r)
    for (std::uint32_t s = 0; s < sides; ++s) {
      triangles.push_back({at(r, s), at(r + 1, s), at(r + 1, s + 1)});
      triangles.push_back({at(r, s), at(r + 1, s + 1), at(r, s + 1)});
    }
  return triangles;
}

}  // namespace pelt::test

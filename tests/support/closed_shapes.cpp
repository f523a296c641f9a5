#include "support/closed_shapes.hpp"

#include "support/pinned_shapes.hpp"

#include <array>
#include <cmath>

namespace pelt::test {

Shape make_rigid(const std::vector<Vec3>& positions, const std::vector<Triangle>& triangles) {
  Shape shape;
  shape.rest_positions = positions;
  shape.triangles = triangles;
  shape.influences_per_vertex = 1;
  shape.joints.assign(positions.size(), 0);
  shape.weights.assign(positions.size(), 1);
  return shape;
}

Shape make_cube(float half, const Vec3& centre) {
  std::vector<Vec3> positions;
  for (const float z : {-half, half})
    for (const float y : {-half, half})
      for (const float x : {-half, half})
        positions.push_back({centre.x + x, centre.y + y, centre.z + z});
  constexpr std::array<std::array<std::uint32_t, 4>, 6> kSides = {
      {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
  std::vector<Triangle> triangles;
  for (const auto& side : kSides) {
    const auto middle = static_cast<std::uint32_t>(positions.size());
    Vec3 sum;
    for (const std::uint32_t corner : side)
      sum = {sum.x + positions[corner].x, sum.y + positions[corner].y, sum.z + positions[corner].z};
    positions.push_back({sum.x / 4, sum.y / 4, sum.z / 4});
    for (std::size_t i = 0; i < 4; ++i) triangles.push_back({side[i], side[(i + 1) % 4], middle});
  }
  return make_rigid(positions, triangles);
}

Shape make_sphere(float radius, int cuts) {
  Shape shape = make_rigid({{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
                           octahedron());
  for (int i = 0; i < cuts; ++i) shape = cut(shape);
  for (Vec3& p : shape.rest_positions) {
    const float scale = radius / std::sqrt(p.x * p.x + p.y * p.y + p.z * p.z);
    p = {scale * p.x, scale * p.y, scale * p.z};
  }
  return shape;
}

Shape together(const Shape& a, const Shape& b) {
  std::vector<Vec3> positions = a.rest_positions;
  positions.insert(positions.end(), b.rest_positions.begin(), b.rest_positions.end());
  std::vector<Triangle> triangles = a.triangles;
  const auto shift = static_cast<std::uint32_t>(a.rest_positions.size());
  for (const Triangle& t : b.triangles)
    triangles.push_back({t[0] + shift, t[1] + shift, t[2] + shift});
  return make_rigid(positions, triangles);
}

Shape cut(const Shape& shape) {
  std::vector<Vec3> positions;
  std::vector<Triangle> triangles;
  const auto middle = [](const Vec3& p, const Vec3& q) {
    return Vec3{(p.x + q.x) / 2, (p.y + q.y) / 2, (p.z + q.z) / 2};
  };
  for (const Triangle& t : shape.triangles) {
    const Vec3 &a = shape.rest_positions[t[0]], &b = shape.rest_positions[t[1]];
    const Vec3& c = shape.rest_positions[t[2]];
    const auto first = static_cast<std::uint32_t>(positions.size());
    for (const Vec3& p : {a, b, c, middle(a, b), middle(b, c), middle(c, a)})
      positions.push_back(p);
    for (const Triangle& part :
         {Triangle{0, 3, 5}, Triangle{3, 1, 4}, Triangle{5, 4, 2}, Triangle{3, 4, 5}})
      triangles.push_back({first + part[0], first + part[1], first + part[2]});
  }
  return make_rigid(positions, triangles);
}

}  // namespace pelt::test

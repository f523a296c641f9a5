#pragma once

/// Meshes whose triangles share vertices in every way, for the tests of fans and masks.

#include "support/skinned_shapes.hpp"

#include <array>

namespace pelt::test {

/// Appends a vertex that follows one joint.
inline std::uint32_t add_vertex(Shape& shape, const Vec3& position, std::uint16_t joint = 0) {
  shape.rest_positions.push_back(Vec3(position));
  for (std::uint32_t i = 0; i < shape.influences_per_vertex; ++i) {
    shape.joints.push_back(std::uint16_t{joint});
    shape.weights.push_back(i == 0 ? 1.0f : 0.0f);
  }
  return static_cast<std::uint32_t>(shape.rest_positions.size() - 1);
}

/// Random triangles between few points. Each corner is a vertex of its own, which follows one of
/// `joint_count` joints: vertices at one point are often one surface vertex, cracked or not.
inline Shape make_grid_soup(Random& random, std::uint32_t triangle_count, std::uint32_t points,
                            std::uint32_t joint_count) {
  Shape shape;
  shape.influences_per_vertex = 1;
  shape.joint_count = joint_count;
  const auto coordinate = [&] { return static_cast<float>(random.index(points)); };
  for (std::uint32_t t = 0; t < triangle_count; ++t) {
    std::array<std::uint32_t, 3> corners;
    for (std::uint32_t& corner : corners)
      corner = add_vertex(shape, {coordinate(), coordinate(), coordinate()},
                          static_cast<std::uint16_t>(random.index(joint_count)));
    shape.triangles.push_back(corners);
  }
  return shape;
}

/// A disc or, if not closed, a slice: triangles around one vertex, each sharing an edge with the
/// next. Triangles are listed in random order, starting at random corners.
inline void add_fan(Random& random, Shape& shape, std::uint32_t triangle_count, bool is_closed,
                    Vec3 centre) {
  const std::uint32_t hub = add_vertex(shape, centre), first = hub + 1;
  const std::uint32_t spokes = is_closed ? triangle_count : triangle_count + 1;
  for (std::uint32_t i = 0; i < spokes; ++i) {
    const double angle = 6 * i / static_cast<double>(spokes);
    add_vertex(shape, {centre.x + static_cast<float>(std::cos(angle)),
                       centre.y + static_cast<float>(std::sin(angle)), centre.z});
  }
  const std::size_t before = shape.triangles.size();
  for (std::uint32_t i = 0; i < triangle_count; ++i) {
    const Triangle t = {hub, first + i, first + (i + 1) % spokes};
    const std::size_t turn = random.index(3);
    shape.triangles.push_back({t[turn], t[(turn + 1) % 3], t[(turn + 2) % 3]});
    std::swap(shape.triangles.back(), shape.triangles[before + random.index(i + 1)]);
  }
}

/// Removes triangles at random, and repeats others.
inline void tear(Random& random, Shape& shape, double removed, double repeated) {
  std::vector<Triangle> triangles;
  for (const Triangle& t : shape.triangles) {
    if (!random.chance(removed)) triangles.push_back(t);
    if (random.chance(repeated)) triangles.push_back({t[1], t[2], t[0]});
  }
  shape.triangles = triangles;
}

/// Moves corners to copies of their vertices, some of which follow another joint.
inline void split_corners(Random& random, Shape& shape, double probability, double cracked) {
  const std::uint32_t k = shape.influences_per_vertex;
  for (Triangle& triangle : shape.triangles)
    for (std::uint32_t& vertex : triangle) {
      if (!random.chance(probability)) continue;
      const std::uint32_t copy = add_vertex(shape, shape.rest_positions[vertex]);
      for (std::uint32_t i = 0; i < k; ++i) {
        shape.joints[copy * k + i] = shape.joints[vertex * k + i];
        shape.weights[copy * k + i] = shape.weights[vertex * k + i];
      }
      if (random.chance(cracked))
        shape.joints[copy * k] = static_cast<std::uint16_t>(random.index(shape.joint_count));
      vertex = copy;
    }
}

}  // namespace pelt::test

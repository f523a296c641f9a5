#include "pose/pose_boxes.hpp"

#include "skin/skinned_mesh.hpp"

#include <cmath>
#include <cstring>

namespace pelt::detail {
namespace {

bool is_within(float coordinate) { return std::fabs(coordinate) <= kMaxCoordinate; }

/// Precondition: a coordinate is not within the limit.
Problem describe_first(std::span<const Vec3> vertices) {
  std::size_t v = 0;
  const auto is_good = [](const Vec3& p) {
    return is_within(p.x) && is_within(p.y) && is_within(p.z);
  };
  while (is_good(vertices[v])) ++v;
  const Vec3& p = vertices[v];
  return problem("vertices[%zu] is (%g, %g, %g), expected finite coordinates within 2^60", v,
                 static_cast<double>(p.x), static_cast<double>(p.y), static_cast<double>(p.z));
}

}  // namespace

GivenVertices copy_given(const Tree& tree, const GivenVertices& given, Arena& arena) {
  std::byte* const positions = arena.allocate(bytes_of_positions(tree));
  std::byte* const boxes = arena.allocate(bytes_of_boxes(tree));
  std::memcpy(positions, given.positions, bytes_of_positions(tree));
  std::memcpy(boxes, given.boxes, bytes_of_boxes(tree));
  return {reinterpret_cast<const float*>(positions), reinterpret_cast<const GivenBox*>(boxes)};
}

Problem check_vertices(const Tree& tree, std::span<const Vec3> vertices) {
  if (vertices.size() != tree.vertex_count())
    return problem("vertices has %zu elements, expected one for each of the model's %u vertices",
                   vertices.size(), tree.vertex_count());
  if (!are_within(vertices)) return describe_first(vertices);
  for (const WeldedVertex& welded : tree.welded_vertices)
    if (!(vertices[welded.vertex] == vertices[welded.into]))
      return problem(
          "vertices[%u] differs from vertices[%u], but the model has merged both because they are "
          "equal in the rest pose: build it with ModelOptions::weld = false",
          welded.vertex, welded.into);
  return {};
}

}  // namespace pelt::detail

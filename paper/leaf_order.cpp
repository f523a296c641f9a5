#include "paper/leaf_order.hpp"

namespace pelt::paper {
namespace {

constexpr std::uint32_t kNew = 0xFFFFFFFF;

void append_vertex(const SkinnedMesh& from, std::uint32_t v, SkinnedMesh& to) {
  to.rest_positions.push_back(from.rest_positions[v]);
  const auto influences = from.influences_of(v);
  to.influences.insert(to.influences.end(), influences.begin(), influences.end());
  to.influence_begin.push_back(static_cast<std::uint32_t>(to.influences.size()));
}

}  // namespace

SkinnedMesh in_leaf_order(const SkinnedMesh& mesh, const SphereTree& tree) {
  SkinnedMesh ordered;
  ordered.joint_count = mesh.joint_count;
  ordered.rest_extent = mesh.rest_extent;
  ordered.influence_begin.push_back(0);
  std::vector<std::uint32_t> new_number(mesh.vertex_count(), kNew);
  for (const std::uint32_t t : tree.triangle_order) {
    Triangle triangle = mesh.triangles[t];
    for (std::uint32_t& v : triangle) {
      std::uint32_t& number = new_number[v];
      if (number == kNew) {
        number = ordered.vertex_count();
        append_vertex(mesh, v, ordered);
      }
      v = number;
    }
    ordered.triangles.push_back(triangle);
  }
  return ordered;
}

}  // namespace pelt::paper

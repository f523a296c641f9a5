#include "tools/pelt/scene/part_mesh.hpp"

#include <algorithm>

namespace pelt::tools::scene {

PartMesh::PartMesh(const SkinnedMeshView& whole, const asset::Part& part)
    : influences_per_vertex_(whole.influences_per_vertex), joint_count_(whole.joint_count) {
  add_triangles(whole.triangles.subspan(part.first_triangle, part.triangle_count));
  add_vertices(whole);
  add_morph_targets(whole.morph_targets);
}

void PartMesh::add_triangles(std::span<const Triangle> triangles) {
  triangles_.assign(triangles.begin(), triangles.end());
  for (const Triangle& triangle : triangles)
    used_.insert(used_.end(), triangle.begin(), triangle.end());
  std::sort(used_.begin(), used_.end());
  used_.erase(std::unique(used_.begin(), used_.end()), used_.end());
  for (Triangle& triangle : triangles_)
    for (std::uint32_t& vertex : triangle)
      vertex = static_cast<std::uint32_t>(std::lower_bound(used_.begin(), used_.end(), vertex) -
                                          used_.begin());
}

void PartMesh::add_vertices(const SkinnedMeshView& whole) {
  const std::size_t k = influences_per_vertex_;
  for (const std::uint32_t vertex : used_) {
    rest_positions_.push_back(whole.rest_positions[vertex]);
    const auto joints = whole.joints.subspan(vertex * k, k);
    const auto weights = whole.weights.subspan(vertex * k, k);
    joints_.insert(joints_.end(), joints.begin(), joints.end());
    weights_.insert(weights_.end(), weights.begin(), weights.end());
  }
}

void PartMesh::add_morph_targets(const MorphTargetsView& targets) {
  if (targets.begin.empty()) return;
  morph_begin_.push_back(0);
  for (std::size_t m = 0; m + 1 < targets.begin.size(); ++m) {
    auto next = targets.vertices.begin() + targets.begin[m];
    const auto end = targets.vertices.begin() + targets.begin[m + 1];
    for (std::uint32_t v = 0; v < used_.size(); ++v) {
      next = std::lower_bound(next, end, used_[v]);
      if (next == end) break;
      if (*next != used_[v]) continue;
      morph_vertices_.push_back(v);
      displacements_.push_back(
          targets.displacements[static_cast<std::size_t>(next - targets.vertices.begin())]);
    }
    morph_begin_.push_back(static_cast<std::uint32_t>(morph_vertices_.size()));
  }
}

SkinnedMeshView PartMesh::view() const {
  return {rest_positions_,
          triangles_,
          influences_per_vertex_,
          joints_,
          weights_,
          joint_count_,
          {morph_begin_, morph_vertices_, displacements_}};
}

}  // namespace pelt::tools::scene

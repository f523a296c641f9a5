#include "tools/pelt/scene/part_mesh.hpp"

#include <algorithm>

namespace pelt::tools::scene {
namespace {

template <typename T>
void sort_unique(std::vector<T>& numbers) {
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
}

/// Precondition: `numbers` ascend and contain `number`.
template <typename T>
T index_in(const std::vector<T>& numbers, T number) {
  return static_cast<T>(std::lower_bound(numbers.begin(), numbers.end(), number) - numbers.begin());
}

}  // namespace

PartMesh::PartMesh(const SkinnedMeshView& whole, const asset::Part& part)
    : influences_per_vertex_(whole.influences_per_vertex) {
  add_triangles(whole.triangles.subspan(part.first_triangle, part.triangle_count));
  add_vertices(whole);
  renumber_joints();
  add_morph_targets(whole.morph_targets);
}

void PartMesh::add_triangles(std::span<const Triangle> triangles) {
  triangles_.assign(triangles.begin(), triangles.end());
  for (const Triangle& triangle : triangles)
    used_.insert(used_.end(), triangle.begin(), triangle.end());
  sort_unique(used_);
  for (Triangle& triangle : triangles_)
    for (std::uint32_t& vertex : triangle) vertex = index_in(used_, vertex);
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

/// Influences of weight 0 may name any joint, so they follow the first one.
void PartMesh::renumber_joints() {
  for (std::size_t i = 0; i < joints_.size(); ++i)
    if (weights_[i] > 0) used_joints_.push_back(joints_[i]);
  sort_unique(used_joints_);
  for (std::size_t i = 0; i < joints_.size(); ++i)
    joints_[i] = weights_[i] > 0 ? index_in(used_joints_, joints_[i]) : std::uint16_t{0};
}

void PartMesh::add_morph_targets(const MorphTargetsView& targets) {
  for (std::uint32_t m = 0; m + 1 < targets.begin.size(); ++m) {
    add_displacements(targets, m);
    const auto end = static_cast<std::uint32_t>(morph_vertices_.size());
    if (end == morph_begin_.back()) continue;
    morph_begin_.push_back(end);
    used_targets_.push_back(m);
  }
}

void PartMesh::add_displacements(const MorphTargetsView& targets, std::uint32_t target) {
  auto next = targets.vertices.begin() + targets.begin[target];
  const auto end = targets.vertices.begin() + targets.begin[target + 1];
  for (std::uint32_t v = 0; v < used_.size(); ++v) {
    next = std::lower_bound(next, end, used_[v]);
    if (next == end) break;
    if (*next != used_[v]) continue;
    morph_vertices_.push_back(v);
    displacements_.push_back(
        targets.displacements[static_cast<std::size_t>(next - targets.vertices.begin())]);
  }
}

SkinnedMeshView PartMesh::view() const {
  return {rest_positions_,
          triangles_,
          influences_per_vertex_,
          joints_,
          weights_,
          static_cast<std::uint32_t>(used_joints_.size()),
          {morph_begin_, morph_vertices_, displacements_}};
}

}  // namespace pelt::tools::scene

#include "scenes/triangle_labels.hpp"

#include "scenes/mesh_without_morphs.hpp"
#include "skin/main_joint.hpp"

#include <algorithm>

namespace pelt::scenes {
namespace {

std::vector<std::uint32_t> parts_of_triangles(const asset::Asset& asset) {
  std::vector<std::uint32_t> parts(asset.triangles.size());
  for (std::uint32_t p = 0; p < asset.parts.size(); ++p) {
    const asset::Part& part = asset.parts[p];
    std::fill_n(parts.begin() + part.first_triangle, part.triangle_count, p);
  }
  return parts;
}

}  // namespace

Result<TriangleLabels> label_triangles(const asset::Asset& asset) {
  if (asset.triangles.empty()) return TriangleLabels{};
  const Result<detail::SkinnedMesh> mesh = mesh_without_morphs(asset);
  if (!mesh) return mesh.error();
  return TriangleLabels{detail::main_joints(*mesh), parts_of_triangles(asset)};
}

}  // namespace pelt::scenes

#include "scenes/triangle_labels.hpp"

#include "self/near_joints.hpp"
#include "skin/skin.hpp"
#include "skin/skinned_mesh.hpp"

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

Result<detail::SkinnedMesh> mesh_without_morphs(const asset::Asset& asset) {
  SkinnedMeshView view = asset.mesh();
  view.morph_targets = {};
  ModelOptions options;
  options.off_weights = OffWeights::renormalise;
  BuildReport report;
  return detail::make_skinned_mesh(view, options, report);
}

Result<TriangleLabels> label_triangles(const asset::Asset& asset) {
  if (asset.triangles.empty()) return TriangleLabels{};
  const Result<detail::SkinnedMesh> mesh = mesh_without_morphs(asset);
  if (!mesh) return mesh.error();
  return TriangleLabels{detail::main_joints(*mesh), parts_of_triangles(asset)};
}

std::vector<Vec3> default_positions(const asset::Asset& asset) {
  std::vector<Vec3> positions = asset.rest_positions;
  const Result<detail::SkinnedMesh> mesh = mesh_without_morphs(asset);
  if (!mesh) return positions;
  std::vector<Matrix4> matrices(asset.joints.size());
  asset::SampleScratch scratch;
  asset::sample_palette(asset, nullptr, 0, Matrix4{}, scratch, matrices);
  detail::Palette palette(mesh->joint_count, detail::extent_of(mesh->rest_positions));
  if (palette.set(matrices)) detail::posed_vertices(*mesh, palette, positions);
  return positions;
}

NearJoints near_joints(const asset::Asset& asset, std::span<const std::uint16_t> main_joints,
                       std::span<const Contact> at_rest) {
  return detail::near_joints(
      {asset.rest_positions, default_positions(asset), asset.triangles, main_joints},
      asset::joint_bodies(asset), at_rest);
}

}  // namespace pelt::scenes

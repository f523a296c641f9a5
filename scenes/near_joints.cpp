#include "scenes/near_joints.hpp"

#include "scenes/mesh_without_morphs.hpp"
#include "self/near_joints.hpp"
#include "skin/skin.hpp"
#include "skin/skinned_mesh.hpp"

namespace pelt::scenes {

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

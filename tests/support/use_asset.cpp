#include "support/use_asset.hpp"

#include <pelt/pelt.hpp>

namespace pelt::test {

namespace {

bool pose_at(const asset::Asset& asset, const asset::Clip* clip, float seconds, Pose& pose) {
  asset::SampleScratch scratch;
  std::vector<Matrix4> palette(asset.joints.size());
  asset::sample_palette(asset, clip, seconds, Matrix4{}, scratch, palette);
  std::vector<float> weights(asset.morph_targets.size());
  asset::sample_morph_weights(asset, clip, seconds, weights);
  if (!pose.set_palette(palette) || !pose.set_morph_weights(weights)) return false;
  std::vector<Vec3> posed(asset.rest_positions.size());
  posed_vertices(pose, posed);
  return true;
}

}  // namespace

bool use_asset(const asset::Asset& asset) {
  constexpr std::size_t kMaxTriangles = 20000;  // limits the time per input
  if (asset.triangles.size() > kMaxTriangles) return false;
  const Result<SkinnedModel> model = build_model(asset.mesh());
  if (!model) return false;
  Pose pose(*model);
  bool accepted = pose_at(asset, nullptr, 0, pose);
  for (const asset::Clip& clip : asset.clips) {
    accepted &= pose_at(asset, &clip, 0, pose);
    accepted &= pose_at(asset, &clip, clip.duration / 3, pose);
    accepted &= pose_at(asset, &clip, clip.duration, pose);
  }
  for (std::uint32_t triangle = 0; triangle < asset.triangles.size(); ++triangle) {
    accepted &= asset.part_of(triangle).triangle_count > 0;
  }
  return accepted;
}

}  // namespace pelt::test

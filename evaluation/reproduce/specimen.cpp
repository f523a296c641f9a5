#include "evaluation/reproduce/specimen.hpp"

#include "base/assert.hpp"
#include "model/model.hpp"
#include "model/unpack.hpp"

namespace pelt::reproduce {

Result<Specimen> make_specimen(asset::Asset asset) {
  const Result<SkinnedModel> model = build_model(asset.mesh());
  if (!model) return model.error();
  detail::SkinnedMesh mesh = detail::unpack_mesh(model->detail().tree);
  return Specimen{std::move(asset), *model, std::move(mesh)};
}

Result<Specimen> make_specimen(const scenes::CreatureOptions& options) {
  Result<asset::Asset> asset = scenes::make_creature(options);
  if (!asset) return asset.error();
  return make_specimen(std::move(*asset));
}

detail::Palette walking_palette(const Specimen& specimen, float seconds) {
  const asset::Asset& asset = specimen.asset;
  std::vector<Matrix4> joints(asset.joints.size());
  asset::SampleScratch scratch;
  asset::sample_palette(asset, asset.find_clip("walk"), seconds, {}, scratch, joints);
  detail::Palette palette(specimen.mesh.joint_count, specimen.mesh.rest_extent);
  const Result<void> taken = palette.set(joints);
  PELT_ASSERT(taken);
  return palette;
}

}  // namespace pelt::reproduce

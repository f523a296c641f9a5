#include "scenes/mesh_without_morphs.hpp"

namespace pelt::scenes {

Result<detail::SkinnedMesh> mesh_without_morphs(const asset::Asset& asset) {
  SkinnedMeshView view = asset.mesh();
  view.morph_targets = {};
  ModelOptions options;
  options.off_weights = OffWeights::renormalise;
  BuildReport report;
  return detail::make_skinned_mesh(view, options, report);
}

}  // namespace pelt::scenes

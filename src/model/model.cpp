#include "model/model.hpp"

#include <utility>

namespace pelt {

SkinnedModel::SkinnedModel(std::shared_ptr<const detail::Model> model) : model_(std::move(model)) {}

std::uint32_t SkinnedModel::vertex_count() const { return model_->mesh.vertex_count(); }
std::uint32_t SkinnedModel::triangle_count() const { return model_->mesh.triangle_count(); }
std::uint32_t SkinnedModel::joint_count() const { return model_->mesh.joint_count; }
const BuildReport& SkinnedModel::report() const { return model_->report; }

Result<SkinnedModel> build_model(const SkinnedMeshView& mesh, const ModelOptions& options) {
  auto model = std::make_shared<detail::Model>();
  Result<detail::SkinnedMesh> skinned = detail::make_skinned_mesh(mesh, options, model->report);
  if (!skinned) return skinned.error();
  model->mesh = *std::move(skinned);
  model->engine = detail::build_engine(model->mesh);
  return SkinnedModel(std::move(model));
}

}  // namespace pelt

#include "model/model.hpp"

#include "base/bytes_held.hpp"
#include "base/problem.hpp"
#include "model/node_bounds.hpp"
#include "model/tree_build.hpp"
#include "skin/skin.hpp"

#include <utility>

namespace pelt {
namespace {

using detail::invalid_argument;
using detail::Palette;
using detail::problem;
using detail::SkinnedMesh;

Palette rest_palette_without_morphs(const SkinnedMesh& mesh) {
  return Palette(mesh.joint_count, mesh.rest_extent, {}, mesh.dual_influences);
}

/// Returns the caller's sample poses, or an error for the first that is not a valid palette.
Result<std::vector<Palette>> take_sample_poses(const SkinnedMesh& mesh,
                                               std::span<const Matrix4> matrices) {
  const std::size_t joints = mesh.joint_count;
  if (matrices.size() % joints != 0)
    return invalid_argument(
        problem("sample_palettes has %zu matrices, expected a multiple of the model's %zu joints",
                matrices.size(), joints));
  std::vector<Palette> palettes(matrices.size() / joints, rest_palette_without_morphs(mesh));
  for (std::size_t s = 0; s < palettes.size(); ++s) {
    const Result<void> taken = palettes[s].set(matrices.subspan(s * joints, joints));
    if (!taken)
      return invalid_argument(
          problem("sample_palettes, pose %zu: %s", s, taken.error().message.c_str()));
  }
  return palettes;
}

/// Returns the rest positions, then the positions of the sample poses.
std::vector<std::vector<Vec3>> sample_positions(const SkinnedMesh& mesh,
                                                std::span<const Palette> palettes) {
  std::vector<std::vector<Vec3>> positions = {mesh.rest_positions};
  for (const Palette& palette : palettes) {
    positions.emplace_back(mesh.vertex_count());
    detail::posed_vertices(mesh, palette, positions.back());
  }
  return positions;
}

}  // namespace

SkinnedModel::SkinnedModel(std::shared_ptr<const detail::Model> model) : model_(std::move(model)) {}

std::uint32_t SkinnedModel::vertex_count() const { return model_->tree.vertex_count(); }
std::uint32_t SkinnedModel::triangle_count() const { return model_->tree.triangle_count(); }
std::uint32_t SkinnedModel::joint_count() const { return model_->tree.joint_count; }
Skinning SkinnedModel::skinning() const {
  return model_->tree.dual_influences > 0 ? Skinning::dual_quaternion : Skinning::linear;
}
std::uint32_t SkinnedModel::morph_target_count() const {
  return model_->tree.morphs.target_count();
}
const BuildReport& SkinnedModel::report() const { return model_->report; }

std::size_t SkinnedModel::memory_bytes() const {
  std::size_t bytes = sizeof(detail::Model) + detail::bytes_held(model_->tree.triangle_places) +
                      detail::bytes_held(model_->tree.triangles_below) +
                      detail::bytes_held(model_->tree.lowest_below) +
                      detail::bytes_held(model_->tree.welded_vertices) +
                      detail::bytes_held(model_->bounds.offset_caps);
  each_array(*model_, [&](const auto& array) { bytes += detail::bytes_held(array); });
  return bytes;
}

Result<SkinnedModel> build_model(const SkinnedMeshView& view, const ModelOptions& options) {
  auto model = std::make_shared<detail::Model>();
  Result<SkinnedMesh> mesh = detail::make_skinned_mesh(view, options, model->report);
  if (!mesh) return mesh.error();
  Result<std::vector<Palette>> samples = take_sample_poses(*mesh, options.sample_palettes);
  if (!samples) return samples.error();
  model->tree = detail::build_tree(*mesh, sample_positions(*mesh, *samples));
  if (samples->empty()) *samples = detail::invent_sample_poses(*mesh);
  model->bounds = detail::fit_node_bounds(model->tree, *samples);
  return SkinnedModel(std::move(model));
}

}  // namespace pelt

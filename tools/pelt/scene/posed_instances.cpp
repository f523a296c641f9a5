#include "tools/pelt/scene/posed_instances.hpp"

#include <pelt/pose.hpp>

#include "scenes/smooth_normals.hpp"
#include "tools/pelt/scene/collider_palettes.hpp"

#include <array>
#include <map>

namespace pelt::tools::scene {
namespace {

/// Size of the instances in a .glb (positions, normals and indices), whose sizes have 32 bits.
Result<void> check_glb_size(const scenes::Scene& scene) {
  constexpr std::uint64_t kMax = 0xF0000000;
  std::uint64_t bytes = 0;
  for (const scenes::Instance& instance : scene.instances) {
    const asset::Asset& asset = scene.characters[instance.character].asset;
    bytes += 24 * asset.rest_positions.size() + 12 * asset.triangles.size();
  }
  if (bytes <= kMax) return {};
  return Error{ErrorCode::unsupported,
               scene.name + ": the posed characters take " + std::to_string(bytes >> 20) +
                   " MiB, more than a .glb file can contain: use fewer instances"};
}

/// Built without sample poses, because these models only pose vertices.
Result<std::vector<SkinnedModel>> build_models(const scenes::Scene& scene,
                                               const arguments::ModelArguments& arguments) {
  std::vector<SkinnedModel> models;
  for (const scenes::Character& character : scene.characters) {
    Result<SkinnedModel> model =
        arguments::build_named_model(character, character.asset.mesh(), arguments);
    if (!model) return model.error();
    models.push_back(std::move(*model));
  }
  return models;
}

Result<std::vector<Vec3>> pose_vertices(const SkinnedModel& model, const PoseInputs& inputs) {
  Pose pose(model);
  if (const auto posed = set_pose(inputs, pose); !posed) return posed.error();
  std::vector<Vec3> positions(model.vertex_count());
  posed_vertices(pose, positions);
  return positions;
}

/// Returns for each position the first vertex at the same position.
std::vector<std::uint32_t> first_at_place(std::span<const Vec3> positions) {
  std::map<std::array<float, 3>, std::uint32_t> first;
  std::vector<std::uint32_t> result;
  for (std::uint32_t v = 0; v < positions.size(); ++v) {
    const Vec3& p = positions[v];
    result.push_back(first.try_emplace({p.x, p.y, p.z}, v).first->second);
  }
  return result;
}

}  // namespace

Result<std::vector<PosedInstance>> pose_instances(const scenes::Scene& scene, std::uint32_t frame,
                                                  const arguments::ModelArguments& arguments) {
  if (const Result<void> fits = check_glb_size(scene); !fits) return fits.error();
  const Result<std::vector<SkinnedModel>> models = build_models(scene, arguments);
  if (!models) return models.error();
  asset::SampleScratch scratch;
  Palettes palettes;
  sample_palettes(scene, frame, scratch, palettes);
  std::vector<PosedInstance> posed;
  for (std::uint32_t i = 0; i < scene.instances.size(); ++i) {
    const std::uint32_t c = scene.instances[i].character;
    Result<std::vector<Vec3>> positions =
        pose_vertices((*models)[c], inputs_of_instance(palettes, i));
    if (!positions) return in_instance(i, positions.error());
    posed.push_back({scene.characters[c].name + " " + std::to_string(i), std::move(*positions),
                     scene.characters[c].asset.triangles});
  }
  return posed;
}

std::vector<Vec3> normals_of(const PosedInstance& instance) {
  std::vector<Vec3> normals(instance.positions.size());
  scenes::smooth_normals(instance.positions, instance.triangles, first_at_place(instance.positions),
                         normals);
  return normals;
}

}  // namespace pelt::tools::scene

#include "tools/pelt/scene/collider_palettes.hpp"

#include "text/message.hpp"

namespace pelt::tools::scene {
namespace {

/// Replaces the content of `selected` with the elements of `all` at `indices`.
template <typename T, typename Index>
void select_from(const std::vector<T>& all, const std::vector<Index>& indices,
                 std::vector<T>& selected) {
  selected.clear();
  for (const Index index : indices) selected.push_back(all[index]);
}

/// A palette has the functions of a pose by other names.
struct PalettePoser {
  Result<void> set_morph_weights(std::span<const float> weights) {
    return palette.set_morph_weights(weights);
  }
  Result<void> set_palette(std::span<const Matrix4> joints) { return palette.set(joints); }

  detail::Palette& palette;
};

}  // namespace

void sample_palettes(const scenes::Scene& scene, std::uint32_t frame, asset::SampleScratch& scratch,
                     Palettes& palettes) {
  sample_palettes(scene, scenes::Moment{frame, 0}, scratch, palettes);
}

void sample_palettes(const scenes::Scene& scene, const scenes::Moment& moment,
                     asset::SampleScratch& scratch, Palettes& palettes) {
  for (std::uint32_t i = 0; i < scene.instances.size(); ++i)
    sample_instance(scene, i, moment, scratch, palettes);
}

void sample_instance(const scenes::Scene& scene, std::uint32_t instance,
                     const scenes::Moment& moment, asset::SampleScratch& scratch,
                     Palettes& palettes) {
  palettes.joints.resize(scene.instances.size());
  palettes.morphs.resize(scene.instances.size());
  const asset::Asset& asset = scene.characters[scene.instances[instance].character].asset;
  palettes.joints[instance].resize(asset.joints.size());
  palettes.morphs[instance].resize(asset.morph_targets.size());
  scenes::instance_palette(scene, instance, moment, scratch, palettes.joints[instance]);
  scenes::instance_morph_weights(scene, instance, moment, palettes.morphs[instance]);
}

PoseInputs InputSelection::select(const Palettes& palettes, const Collider& collider) {
  if (!collider.rig) return inputs_of_instance(palettes, collider.instance);
  select_from(palettes.joints[collider.instance], collider.rig->joints, joints_);
  select_from(palettes.morphs[collider.instance], collider.rig->morph_targets, morphs_);
  return {joints_, morphs_};
}

Error in_instance(std::uint32_t instance, const Error& error) {
  return text::prefixed("instances[" + std::to_string(instance) + "]", error);
}

Result<void> pose_vertices(const PoseInputs& inputs, Pose& pose, std::vector<Vec3>& positions) {
  if (const auto posed = set_pose(inputs, pose); !posed) return posed;
  positions.resize(pose.model().vertex_count());
  posed_vertices(pose, positions);
  return {};
}

PartedInstances::PartedInstances(std::span<const Collider> colliders) {
  for (const Collider& collider : colliders) {
    const bool is_known = !parted_.empty() && parted_.back().instance == collider.instance;
    if (collider.rig && !is_known)
      parted_.push_back({collider.instance, *collider.rig->palette_of_whole});
  }
}

Result<void> PartedInstances::check(const Palettes& palettes) {
  for (auto& [instance, palette] : parted_) {
    PalettePoser poser = {palette};
    const auto posed = set_pose(inputs_of_instance(palettes, instance), poser);
    if (!posed) return in_instance(instance, posed.error());
  }
  return {};
}

}  // namespace pelt::tools::scene

#include "tools/pelt/scene/palettes.hpp"

namespace pelt::tools::scene {

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

}  // namespace pelt::tools::scene

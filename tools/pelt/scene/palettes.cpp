#include "tools/pelt/scene/palettes.hpp"

namespace pelt::tools::scene {

void sample_palettes(const scenes::Scene& scene, std::uint32_t frame, asset::SampleScratch& scratch,
                     Palettes& palettes) {
  palettes.joints.resize(scene.instances.size());
  palettes.morphs.resize(scene.instances.size());
  for (std::uint32_t i = 0; i < scene.instances.size(); ++i) {
    const asset::Asset& asset = scene.characters[scene.instances[i].character].asset;
    palettes.joints[i].resize(asset.joints.size());
    palettes.morphs[i].resize(asset.morph_targets.size());
    scenes::instance_palette(scene, i, frame, scratch, palettes.joints[i]);
    scenes::instance_morph_weights(scene, i, frame, palettes.morphs[i]);
  }
}

}  // namespace pelt::tools::scene

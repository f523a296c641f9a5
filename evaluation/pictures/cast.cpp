#include "evaluation/pictures/cast.hpp"

#include "tools/pelt/scene/scene_query.hpp"

#include <cstdio>
#include <cstdlib>

namespace pelt::pictures {
namespace {

template <typename T>
T demand(Result<T> result) {
  if (result) return std::move(*result);
  std::fprintf(stderr, "%s\n", result.error().message.c_str());
  std::exit(1);
}

Pose pose_of(const scenes::Scene& scene, std::size_t instance,
             const tools::scene::Palettes& palettes) {
  const asset::Asset& asset = scene.characters[scene.instances[instance].character].asset;
  Pose pose(demand(build_model(asset.mesh())));
  if (!pose.set_palette(palettes[instance]) || !pose.set_morph_weights(palettes.morphs[instance]))
    std::abort();
  return pose;
}

}  // namespace

Cast::Cast(std::string_view scene_text, std::uint32_t frame)
    : Cast(demand(scenes::parse_scene(scene_text, {})), frame) {}

Cast::Cast(scenes::Scene scene, std::uint32_t frame)
    : scene_(std::make_unique<scenes::Scene>(std::move(scene))) {
  asset::SampleScratch scratch;
  tools::scene::Palettes palettes;
  tools::scene::sample_palettes(*scene_, frame, scratch, palettes);
  std::vector<tools::scene::PosedInstance> posed =
      demand(tools::scene::pose_instances(*scene_, frame, {}));
  for (std::size_t i = 0; i < posed.size(); ++i)
    actors.push_back({pose_of(*scene_, i, palettes), std::move(posed[i])});
}

}  // namespace pelt::pictures

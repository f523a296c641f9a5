#include "tools/pelt/picture/still_frame.hpp"

#include "tools/pelt/methods/command_methods.hpp"
#include "tools/pelt/scene/scene_glb.hpp"
#include "tools/pelt/scene/scene_query.hpp"

namespace pelt::tools::picture {

Result<StillFrame> take_still(const scenes::Scene& scene, std::uint32_t frame) {
  const auto colliders = scene::make_colliders(scene, scene::Granularity::instance, {});
  if (!colliders) return colliders.error();
  auto posed = scene::pose_instances(scene, frame, {});
  if (!posed) return posed.error();
  asset::SampleScratch scratch;
  scene::Palettes palettes;
  scene::sample_palettes(scene, frame, scratch, palettes);
  scene::SceneQuery query(*colliders, methods::kOnDemand);
  if (const auto set = query.set_palettes(palettes); !set) return set.error();
  scene::FrameContacts found;
  query.collide({}, found);
  auto touching = scene::touching_triangles(*posed, *colliders, found);
  return StillFrame{std::move(*posed), std::move(touching)};
}

}  // namespace pelt::tools::picture

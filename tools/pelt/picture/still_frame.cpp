#include "tools/pelt/picture/still_frame.hpp"

#include "tools/pelt/scene/scene_glb.hpp"
#include "tools/pelt/scene/scene_query.hpp"

namespace pelt::tools {

Result<StillFrame> take_still(const scenes::Scene& scene, std::uint32_t frame) {
  const auto colliders = make_colliders(scene, Granularity::instance, {});
  if (!colliders) return colliders.error();
  auto posed = pose_instances(scene, frame, {});
  if (!posed) return posed.error();
  asset::SampleScratch scratch;
  Palettes palettes;
  sample_palettes(scene, frame, scratch, palettes);
  SceneQuery query(*colliders, bench::MethodKind::on_demand);
  if (const auto set = query.set_palettes(palettes); !set) return set.error();
  FrameContacts found;
  query.collide({}, found);
  auto touching = touching_triangles(*posed, *colliders, found);
  return StillFrame{std::move(*posed), std::move(touching)};
}

}  // namespace pelt::tools

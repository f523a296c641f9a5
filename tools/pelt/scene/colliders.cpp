#include "tools/pelt/scene/colliders.hpp"

#include "scenes/clip_samples.hpp"
#include "tools/pelt/scene/part_mesh.hpp"

#include <algorithm>

namespace pelt::tools::scene {
namespace {

using scenes::Character;

/// Colliders shared by all instances of a character: one per part, or a single one.
Result<std::vector<Collider>> prototypes(const scenes::Scene& scene, std::uint32_t index,
                                         Granularity granularity,
                                         const arguments::ModelArguments& arguments) {
  const Character& character = scene.characters[index];
  const std::vector<Matrix4> samples =
      scenes::clip_samples(character.asset, scenes::played_clips(scene, index), arguments.samples);
  const SkinnedMeshView whole = character.asset.mesh();
  std::vector<Collider> colliders;
  const auto add = [&](const SkinnedMeshView& mesh, std::optional<std::uint32_t> part,
                       std::uint32_t first_triangle) -> Result<void> {
    Result<SkinnedModel> model =
        arguments::build_named_model(character.source, mesh, arguments, samples);
    if (!model) return model.error();
    colliders.push_back({0, part, first_triangle, std::move(*model)});
    return {};
  };
  if (granularity == Granularity::instance) {
    if (const auto added = add(whole, std::nullopt, 0); !added) return added.error();
    return colliders;
  }
  // Check the whole mesh once, so that messages number vertices and triangles as the file does.
  if (const auto checked = arguments::check_named_mesh(character.source, whole, arguments);
      !checked)
    return checked.error();
  for (std::uint32_t p = 0; p < character.asset.parts.size(); ++p) {
    const asset::Part& part = character.asset.parts[p];
    if (part.triangle_count == 0) continue;
    const PartMesh mesh(whole, part);
    if (const auto added = add(mesh.view(), p, part.first_triangle); !added) return added.error();
  }
  return colliders;
}

}  // namespace

Result<std::vector<Collider>> make_colliders(const scenes::Scene& scene, Granularity granularity,
                                             const arguments::ModelArguments& arguments) {
  std::vector<std::vector<Collider>> by_character;
  for (std::uint32_t c = 0; c < scene.characters.size(); ++c) {
    Result<std::vector<Collider>> made = prototypes(scene, c, granularity, arguments);
    if (!made) return made.error();
    by_character.push_back(std::move(*made));
  }
  std::vector<Collider> colliders;
  for (std::uint32_t i = 0; i < scene.instances.size(); ++i) {
    for (Collider collider : by_character[scene.instances[i].character]) {
      collider.instance = i;
      colliders.push_back(std::move(collider));
    }
  }
  return colliders;
}

}  // namespace pelt::tools::scene

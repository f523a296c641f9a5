#include "tools/pelt/scene/colliders.hpp"

#include "asset/file_bytes.hpp"
#include "scenes/clip_samples.hpp"
#include "tools/pelt/scene/part_mesh.hpp"

#include <algorithm>

namespace pelt::tools::scene {
namespace {

using scenes::Character;

/// Makes the colliders of one character, which all its instances share.
class Prototypes {
 public:
  Prototypes(const scenes::Scene& scene, std::uint32_t index,
             const arguments::ModelArguments& arguments)
      : character_(scene.characters[index]),
        arguments_(arguments),
        mesh_(character_.asset.mesh()),
        samples_(scenes::clip_samples(character_.asset, scenes::played_clips(scene, index),
                                      arguments.samples)) {}

  Result<std::vector<Collider>> whole() const {
    Result<SkinnedModel> model = build(mesh_, samples_);
    if (!model) return model.error();
    return std::vector<Collider>{{0, std::nullopt, 0, std::move(*model), nullptr}};
  }

  /// Validates the whole mesh first, so that messages number vertices and triangles as the file
  /// does.
  Result<std::vector<Collider>> parts() const {
    const auto palette = arguments::make_named_palette(character_, mesh_, arguments_);
    if (!palette) return palette.error();
    const auto shared = std::make_shared<const detail::Palette>(*palette);
    std::vector<Collider> colliders;
    for (std::uint32_t p = 0; p < character_.asset.parts.size(); ++p) {
      if (character_.asset.parts[p].triangle_count == 0) continue;
      Result<Collider> made = part(p, shared);
      if (!made) return made.error();
      colliders.push_back(std::move(*made));
    }
    return colliders;
  }

 private:
  Result<Collider> part(std::uint32_t index, std::shared_ptr<const detail::Palette> whole) const {
    const asset::Part& part = character_.asset.parts[index];
    const PartMesh mesh(mesh_, part);
    Result<SkinnedModel> model = build(mesh.view(), samples_of(mesh.joints()));
    if (!model) return model.error();
    return Collider{0, index, part.first_triangle, std::move(*model),
                    std::make_shared<const PartRig>(
                        PartRig{mesh.joints(), mesh.morph_targets(), std::move(whole)})};
  }

  Result<SkinnedModel> build(const SkinnedMeshView& mesh, std::span<const Matrix4> samples) const {
    return arguments::build_named_model(character_, mesh, arguments_, samples);
  }

  /// The sample poses of these joints.
  std::vector<Matrix4> samples_of(std::span<const std::uint16_t> joints) const {
    std::vector<Matrix4> samples;
    for (std::size_t first = 0; first < samples_.size(); first += mesh_.joint_count)
      for (const std::uint16_t joint : joints) samples.push_back(samples_[first + joint]);
    return samples;
  }

  const Character& character_;
  const arguments::ModelArguments& arguments_;
  SkinnedMeshView mesh_;
  std::vector<Matrix4> samples_;
};

Result<std::vector<Collider>> make_prototypes(const scenes::Scene& scene, std::uint32_t character,
                                              Granularity granularity,
                                              const arguments::ModelArguments& arguments) {
  return asset::within_memory(scene.characters[character].source, [&] {
    const Prototypes prototypes(scene, character, arguments);
    return granularity == Granularity::instance ? prototypes.whole() : prototypes.parts();
  });
}

}  // namespace

Result<std::vector<Collider>> make_colliders(const scenes::Scene& scene, Granularity granularity,
                                             const arguments::ModelArguments& arguments) {
  std::vector<std::vector<Collider>> by_character;
  for (std::uint32_t c = 0; c < scene.characters.size(); ++c) {
    Result<std::vector<Collider>> made = make_prototypes(scene, c, granularity, arguments);
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

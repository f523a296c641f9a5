#include "tools/pelt/scene/colliders.hpp"

#include "asset/file_bytes.hpp"
#include "scenes/clip_samples.hpp"

#include <algorithm>

namespace pelt::tools::scene {
namespace {

using scenes::Character;

template <typename T>
void sort_unique(std::vector<T>& numbers) {
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
}

/// Precondition: `numbers` ascend and contain `number`.
template <typename T>
T index_in(const std::vector<T>& numbers, T number) {
  return static_cast<T>(std::lower_bound(numbers.begin(), numbers.end(), number) - numbers.begin());
}

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

PartMesh::PartMesh(const SkinnedMeshView& whole, const asset::Part& part)
    : influences_per_vertex_(whole.influences_per_vertex) {
  add_triangles(whole.triangles.subspan(part.first_triangle, part.triangle_count));
  add_vertices(whole);
  renumber_joints();
  add_morph_targets(whole.morph_targets);
}

void PartMesh::add_triangles(std::span<const Triangle> triangles) {
  triangles_.assign(triangles.begin(), triangles.end());
  for (const Triangle& triangle : triangles)
    used_.insert(used_.end(), triangle.begin(), triangle.end());
  sort_unique(used_);
  for (Triangle& triangle : triangles_)
    for (std::uint32_t& vertex : triangle) vertex = index_in(used_, vertex);
}

void PartMesh::add_vertices(const SkinnedMeshView& whole) {
  const std::size_t k = influences_per_vertex_;
  for (const std::uint32_t vertex : used_) {
    rest_positions_.push_back(whole.rest_positions[vertex]);
    const auto joints = whole.joints.subspan(vertex * k, k);
    const auto weights = whole.weights.subspan(vertex * k, k);
    joints_.insert(joints_.end(), joints.begin(), joints.end());
    weights_.insert(weights_.end(), weights.begin(), weights.end());
  }
}

/// Influences of weight 0 may name any joint, so they follow the first one.
void PartMesh::renumber_joints() {
  for (std::size_t i = 0; i < joints_.size(); ++i)
    if (weights_[i] > 0) used_joints_.push_back(joints_[i]);
  sort_unique(used_joints_);
  for (std::size_t i = 0; i < joints_.size(); ++i)
    joints_[i] = weights_[i] > 0 ? index_in(used_joints_, joints_[i]) : std::uint16_t{0};
}

void PartMesh::add_morph_targets(const MorphTargetsView& targets) {
  for (std::uint32_t m = 0; m + 1 < targets.begin.size(); ++m) {
    add_displacements(targets, m);
    const auto end = static_cast<std::uint32_t>(morph_vertices_.size());
    if (end == morph_begin_.back()) continue;
    morph_begin_.push_back(end);
    used_targets_.push_back(m);
  }
}

void PartMesh::add_displacements(const MorphTargetsView& targets, std::uint32_t target) {
  auto next = targets.vertices.begin() + targets.begin[target];
  const auto end = targets.vertices.begin() + targets.begin[target + 1];
  for (std::uint32_t v = 0; v < used_.size(); ++v) {
    next = std::lower_bound(next, end, used_[v]);
    if (next == end) break;
    if (*next != used_[v]) continue;
    morph_vertices_.push_back(v);
    displacements_.push_back(
        targets.displacements[static_cast<std::size_t>(next - targets.vertices.begin())]);
  }
}

SkinnedMeshView PartMesh::view() const {
  return {rest_positions_,
          triangles_,
          influences_per_vertex_,
          joints_,
          weights_,
          static_cast<std::uint32_t>(used_joints_.size()),
          {morph_begin_, morph_vertices_, displacements_}};
}

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

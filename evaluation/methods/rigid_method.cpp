#include "collide/eager.hpp"
#include "evaluation/methods/lab_methods.hpp"
#include "model/model.hpp"
#include "model/tree_build.hpp"
#include "model/unpack.hpp"
#include "skin/skin.hpp"

#include <algorithm>
#include <map>
#include <numeric>

namespace pelt::lab {
namespace {

using detail::Palette;
using detail::SkinnedMesh;

/// The posed mesh as the rest pose of a single joint.
SkinnedMesh frozen(const SkinnedMesh& mesh, const Palette& palette) {
  SkinnedMesh posed;
  posed.rest_positions.resize(mesh.vertex_count());
  detail::posed_vertices(mesh, palette, posed.rest_positions);
  posed.triangles = mesh.triangles;
  posed.influence_begin.resize(mesh.vertex_count() + 1);
  std::iota(posed.influence_begin.begin(), posed.influence_begin.end(), 0u);
  posed.influences.assign(mesh.vertex_count(), {0, 1.0f});
  posed.joint_count = 1;
  posed.rest_extent = 3 * palette.extent();  // no sum of three coordinates is larger
  return posed;
}

/// A body, posed by one palette.
struct Frozen {
  Frozen(const SkinnedMesh& mesh, const Palette& palette)
      : joints(palette.joints().begin(), palette.joints().end()),
        morphs(palette.morphs().all().begin(), palette.morphs().all().end()),
        tree(build(frozen(mesh, palette))),
        pose(tree) {
    pose.open_all();
  }

  static detail::Tree build(const SkinnedMesh& posed) {
    return detail::build_tree(posed, std::span(&posed.rest_positions, 1));
  }

  std::vector<Matrix4> joints;
  std::vector<float> morphs;
  detail::Tree tree;
  detail::EagerPose pose;
};

class RigidBody {
 public:
  explicit RigidBody(const SkinnedMesh& mesh)
      : mesh_(mesh), palette_(mesh.joint_count, mesh.rest_extent, mesh.morph_extents) {
    freeze();
  }

  Result<void> set_morph_weights(std::span<const float> weights) {
    return palette_.set_morph_weights(weights);
  }

  Result<void> set_palette(std::span<const Matrix4> palette) {
    Result<void> taken = palette_.set(palette);
    if (taken) freeze();
    return taken;
  }

  detail::EagerPose& pose() { return now_->pose; }

 private:
  bool is_of_palette(const Frozen& frozen) const {
    const std::span<const Matrix4> joints = palette_.joints();
    const std::span<const float> morphs = palette_.morphs().all();
    return std::equal(joints.begin(), joints.end(), frozen.joints.begin()) &&
           std::equal(morphs.begin(), morphs.end(), frozen.morphs.begin());
  }

  void freeze() {
    if (now_ && is_of_palette(*now_)) return;
    std::swap(now_, before_);
    if (now_ && is_of_palette(*now_)) return;
    now_ = std::make_unique<Frozen>(mesh_, palette_);
  }

  const SkinnedMesh& mesh_;
  Palette palette_;
  std::unique_ptr<Frozen> now_, before_;
};

class RigidMethod final : public Method {
 public:
  void add(const SkinnedModel& model) override {
    const auto added = meshes_.try_emplace(&model.detail(), model).first;
    bodies_.push_back(std::make_unique<RigidBody>(added->second.mesh));
  }

  Result<void> set_morph_weights(std::uint32_t body, std::span<const float> weights) override {
    return bodies_[body]->set_morph_weights(weights);
  }

  Result<void> set_palette(std::uint32_t body, std::span<const Matrix4> palette) override {
    return bodies_[body]->set_palette(palette);
  }

  bool update_counts() const override { return false; }

  QueryStats collide(std::uint32_t a, std::uint32_t b, std::vector<Contact>& contacts,
                     const Limits& limits) override {
    return detail::collide(bodies_[a]->pose(), bodies_[b]->pose(), scratch_, contacts, limits);
  }

  QueryStats update_work() const override { return {}; }

 private:
  struct ModelMesh {
    explicit ModelMesh(const SkinnedModel& m)
        : model(m), mesh(detail::unpack_mesh(m.detail().tree)) {}

    SkinnedModel model;
    SkinnedMesh mesh;
  };

  std::map<const detail::Model*, ModelMesh> meshes_;
  std::vector<std::unique_ptr<RigidBody>> bodies_;
  detail::Scratch scratch_;
};

}  // namespace

std::unique_ptr<Method> make_rigid() { return std::make_unique<RigidMethod>(); }

}  // namespace pelt::lab

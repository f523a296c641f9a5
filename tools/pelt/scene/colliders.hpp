#pragma once

/// The bodies that are checked against each other: the instances of a scene, or their parts.

#include <pelt/asset.hpp>
#include <pelt/collide.hpp>
#include <pelt/mesh.hpp>
#include <pelt/model.hpp>

#include "scenes/scene.hpp"
#include "skin/palette.hpp"
#include "tools/pelt/arguments/model_arguments.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace pelt::tools::scene {

/// One part of a mesh, with only the vertices that its triangles use, the joints that these follow,
/// and the morph targets that displace them. All are in the order of the whole mesh. Memory and
/// time grow with the part, not with the mesh, apart from one search in each morph target for each
/// vertex.
class PartMesh {
 public:
  /// Copies the data of the part. Precondition: `whole` is valid (see detail::make_skinned_mesh).
  PartMesh(const SkinnedMeshView& whole, const asset::Part& part);

  /// The view borrows from this object.
  SkinnedMeshView view() const;

  /// Numbers in the whole mesh of the joints and morph targets of this one, ascending.
  const std::vector<std::uint16_t>& joints() const { return used_joints_; }
  const std::vector<std::uint32_t>& morph_targets() const { return used_targets_; }

 private:
  void add_triangles(std::span<const Triangle> triangles);
  void add_vertices(const SkinnedMeshView& whole);
  void renumber_joints();
  void add_morph_targets(const MorphTargetsView& targets);
  void add_displacements(const MorphTargetsView& targets, std::uint32_t target);

  std::vector<std::uint32_t> used_;          // vertices of the whole mesh, ascending
  std::vector<std::uint16_t> used_joints_;   // likewise
  std::vector<std::uint32_t> used_targets_;  // likewise
  std::vector<Triangle> triangles_;
  std::vector<Vec3> rest_positions_;
  std::uint32_t influences_per_vertex_;
  std::vector<std::uint16_t> joints_;
  std::vector<float> weights_;
  std::vector<std::uint32_t> morph_begin_ = {0}, morph_vertices_;
  std::vector<Vec3> displacements_;
};

enum class Granularity {
  instance,  ///< two instances collide, never an instance with itself
  part,      ///< every part of every instance is a collider; those of one instance collide too
};

/// The joints and morph targets of a character that one of its parts follows.
struct PartRig {
  std::vector<std::uint16_t> joints;         ///< numbers in the asset, ascending
  std::vector<std::uint32_t> morph_targets;  ///< likewise

  /// Rest pose of the whole character, shared by its parts.
  std::shared_ptr<const detail::Palette> palette_of_whole;
};

struct Collider {
  std::uint32_t instance = 0;
  std::optional<std::uint32_t> part;  ///< index into the asset's parts
  std::uint32_t first_triangle = 0;   ///< added to the model's triangle numbers in answers
  SkinnedModel model;
  std::shared_ptr<const PartRig> rig;  ///< of a part; its model has only these joints

  /// Converts the number of a joint of `model` to its number in the asset.
  std::uint16_t joint_in_asset(std::uint16_t joint) const {
    return rig ? rig->joints[joint] : joint;
  }

  /// Converts a triangle number of `model` to its number in the whole asset, and back.
  std::uint32_t number_in_asset(std::uint32_t triangle) const { return triangle + first_triangle; }
  std::uint32_t number_in_model(std::uint32_t triangle) const { return triangle - first_triangle; }
};

/// Converts a contact of two colliders to triangle numbers of their assets, and back.
inline Contact numbered_in_assets(const Contact& c, const Collider& a, const Collider& b) {
  return {a.number_in_asset(c.triangle_a), b.number_in_asset(c.triangle_b)};
}
inline Contact numbered_in_models(const Contact& c, const Collider& a, const Collider& b) {
  return {a.number_in_model(c.triangle_a), b.number_in_model(c.triangle_b)};
}

/// In order of instances, then parts; parts without triangles are left out. Models are prepared for
/// the clips that the scene plays.
Result<std::vector<Collider>> make_colliders(const scenes::Scene& scene, Granularity granularity,
                                             const arguments::ModelArguments& arguments);

}  // namespace pelt::tools::scene

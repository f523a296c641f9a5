#pragma once

#include <pelt/asset.hpp>
#include <pelt/mesh.hpp>

#include <cstdint>
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

}  // namespace pelt::tools::scene

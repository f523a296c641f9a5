#pragma once

#include <pelt/asset.hpp>
#include <pelt/mesh.hpp>

#include <cstdint>
#include <vector>

namespace pelt::tools::scene {

/// One part of a mesh, with only the vertices that its triangles use. Vertices and triangles have
/// the order of the whole mesh. Memory and time grow with the part, not with the mesh, apart from
/// one search in each morph target for each vertex.
class PartMesh {
 public:
  /// Copies the data of the part. Precondition: the vertex indices of its triangles are in range.
  PartMesh(const SkinnedMeshView& whole, const asset::Part& part);

  /// The view borrows from this object.
  SkinnedMeshView view() const;

 private:
  void add_triangles(std::span<const Triangle> triangles);
  void add_vertices(const SkinnedMeshView& whole);
  void add_morph_targets(const MorphTargetsView& targets);

  std::vector<std::uint32_t> used_;  // vertices of the whole mesh, ascending
  std::vector<Triangle> triangles_;
  std::vector<Vec3> rest_positions_;
  std::uint32_t influences_per_vertex_, joint_count_;
  std::vector<std::uint16_t> joints_;
  std::vector<float> weights_;
  std::vector<std::uint32_t> morph_begin_, morph_vertices_;
  std::vector<Vec3> displacements_;
};

}  // namespace pelt::tools::scene

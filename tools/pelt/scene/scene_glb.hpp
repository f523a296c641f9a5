#pragma once

/// The output of `--glb` and `pelt pose`, for any glTF viewer.

#include <pelt/mesh.hpp>
#include <pelt/model.hpp>

#include "scenes/scene.hpp"
#include "tools/pelt/arguments/model_arguments.hpp"
#include "tools/pelt/scene/colliders.hpp"
#include "tools/pelt/scene/scene_query.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace pelt::tools::scene {

struct GlbMaterial {
  std::string name;
  std::array<float, 3> base_colour = {1, 1, 1};  ///< linear
  std::array<float, 3> emissive = {0, 0, 0};
};

struct GlbPrimitive {
  std::span<const Triangle> triangles;  ///< indices into the mesh's positions; not empty
  std::size_t material = 0;
};

struct GlbMesh {
  std::string name;
  std::span<const Vec3> positions;  ///< written bit for bit; not empty
  std::span<const Vec3> normals;    ///< unit normals, one per position; or empty
  std::vector<GlbPrimitive> primitives;
};

/// Returns a binary glTF 2.0 file of meshes without skins or textures. Node i is a root node with
/// mesh i and no transform.
std::vector<std::byte> make_glb(std::span<const GlbMesh> meshes,
                                std::span<const GlbMaterial> materials);

struct PosedInstance {
  std::string name;                     ///< "knight 0"
  std::vector<Vec3> positions;          ///< exactly the positions that queries use
  std::span<const Triangle> triangles;  ///< borrowed from the scene's asset
};

/// `scene` must outlive the result. Returns an error for instances that are too large for a .glb
/// file.
Result<std::vector<PosedInstance>> pose_instances(const scenes::Scene& scene, std::uint32_t frame,
                                                  const arguments::ModelArguments& arguments);

/// Smooth normals; vertices at the same position share them.
std::vector<Vec3> normals_of(const PosedInstance& instance);

/// The instances as the queries pose them: one root node each in order, one mesh, one primitive,
/// with bit-exact vertices and the triangle numbers of the answers.
std::vector<std::byte> posed_glb(std::span<const PosedInstance> instances);

/// Whether each triangle of each instance is in contact.
std::vector<std::vector<bool>> touching_triangles(std::span<const PosedInstance> instances,
                                                  std::span<const Collider> colliders,
                                                  const FrameContacts& found);

/// The same characters with smooth normals; the triangles in contact have a glowing colour.
std::vector<std::byte> contacts_glb(std::span<const PosedInstance> instances,
                                    const std::vector<std::vector<bool>>& touching);

/// Linear colours that distinguish neighbours; they repeat.
std::array<float, 3> skin_colour(std::size_t instance);

}  // namespace pelt::tools::scene

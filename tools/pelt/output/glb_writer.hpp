#pragma once

/// Writes .glb files: meshes without skins or textures, each on its own root node.

#include <pelt/mesh.hpp>

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace pelt::tools::output {

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

/// Returns a binary glTF 2.0 file; node i has mesh i and no transform.
std::vector<std::byte> make_glb(std::span<const GlbMesh> meshes,
                                std::span<const GlbMaterial> materials);

}  // namespace pelt::tools::output

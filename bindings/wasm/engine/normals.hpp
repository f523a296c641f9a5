#pragma once

#include <pelt/math.hpp>
#include <pelt/mesh.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace pelt {
class Surface;
}

namespace pelt::wasm {

/// For each vertex, one that stands for all that are alike in every bit but the number: exporters
/// split vertices where a texture has a seam.
std::vector<std::uint32_t> find_seams(const Surface& surface, std::span<const Triangle> triangles,
                                      std::uint32_t vertex_count);

/// Normals of unit length, of triangles weighted by their area. Vertices that no triangle uses, or
/// only collapsed ones, get +y.
void smooth_normals(std::span<const Vec3> vertices, std::span<const Triangle> triangles,
                    std::span<const std::uint32_t> seams, std::span<Vec3> normals);

}  // namespace pelt::wasm

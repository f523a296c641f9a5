#pragma once

#include <pelt/math.hpp>
#include <pelt/mesh.hpp>

#include <cstdint>
#include <span>

namespace pelt::scenes {

/// Writes unit normals for smooth shading: the means of the normals of the triangles around a
/// vertex, weighted by area. Vertices without triangles, or with collapsed triangles only, get +y.
///
/// `seams`: for each vertex, the vertex whose normal it shares; a vertex that is shared refers to
///   itself. Exporters split vertices at seams of textures, which should not be visible.
///
/// Precondition: `seams` and `normals` have one element per position.
void smooth_normals(std::span<const Vec3> positions, std::span<const Triangle> triangles,
                    std::span<const std::uint32_t> seams, std::span<Vec3> normals);

}  // namespace pelt::scenes

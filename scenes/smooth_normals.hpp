#pragma once

#include <pelt/math.hpp>
#include <pelt/mesh.hpp>

#include <cstdint>
#include <span>

namespace pelt::scenes {

/// Writes normals of unit length for smooth shading, the triangles around a vertex weighted by
/// their area. `seams` has for each vertex the one whose normal it shares, which shares its own:
/// exporters split vertices where a texture has a seam, and none should show. Vertices that no
/// triangle uses, or only collapsed ones, get +y. Precondition: as many of `seams` and `normals` as
/// of `positions`.
void smooth_normals(std::span<const Vec3> positions, std::span<const Triangle> triangles,
                    std::span<const std::uint32_t> seams, std::span<Vec3> normals);

}  // namespace pelt::scenes

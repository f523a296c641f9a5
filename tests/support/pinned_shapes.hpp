#pragma once

/// Meshes whose posed vertices a test chooses freely, to the bit: each vertex follows a joint of
/// its own, whose matrix maps everything to one point. So posed triangles can be any, collapsed
/// ones too, while the rest positions, by which vertices are welded and trees are built, stay
/// apart.

#include "support/skinned_shapes.hpp"

#include <span>
#include <vector>

namespace pelt::test {

/// A mesh of these triangles on `vertex_count` vertices, with as many joints. Its rest positions
/// are all different, on a spiral.
Shape make_pinned(std::uint32_t vertex_count, const std::vector<Triangle>& triangles);

/// The palette that poses the vertices at `positions`. Precondition: no coordinate is beyond 2^59.
std::vector<Matrix4> pin(std::span<const Vec3> positions);

/// The triangles of closed surfaces by their vertices' numbers.
std::vector<Triangle> tetrahedron();                                    // 4 vertices
std::vector<Triangle> octahedron();                                     // 6 vertices
std::vector<Triangle> torus(std::uint32_t rings, std::uint32_t sides);  // rings * sides vertices

}  // namespace pelt::test

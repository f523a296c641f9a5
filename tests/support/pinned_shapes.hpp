#pragma once

/// Meshes whose posed vertices a test can choose bit by bit: each vertex follows a joint of its
/// own, whose matrix maps everything to one point. Posed triangles can therefore be arbitrary, also
/// collapsed, while the rest positions, which determine welding and the tree, stay distinct.

#include "support/skinned_shapes.hpp"

#include <span>
#include <vector>

namespace pelt::test {

/// A mesh of these triangles with `vertex_count` vertices and as many joints. Its rest positions
/// are distinct points of a spiral.
Shape make_pinned(std::uint32_t vertex_count, const std::vector<Triangle>& triangles);

/// The palette that poses the vertices at `positions`. Precondition: no coordinate exceeds 2^59.
std::vector<Matrix4> pin(std::span<const Vec3> positions);

/// The triangles of closed surfaces as vertex indices.
std::vector<Triangle> tetrahedron();                                    // 4 vertices
std::vector<Triangle> octahedron();                                     // 6 vertices
std::vector<Triangle> torus(std::uint32_t rings, std::uint32_t sides);  // rings * sides vertices

}  // namespace pelt::test

#pragma once

/// Vertices that are one: equal in every bit, or one point of the surface.

#include "model/tree.hpp"
#include "skin/skinned_mesh.hpp"

#include <cstdint>
#include <vector>

namespace pelt::detail {

/// Returns for each vertex [V] the lowest number of a vertex with bit-identical rest position,
/// influences, displacements and offset cap. Exporters split vertices at seams of textures and
/// normals; such vertices are posed to the same bits in any pose. O(V log V) for any input.
std::vector<std::uint32_t> weld_vertices(const SkinnedMesh& mesh);

/// The same, whatever the influences and the signs of zeros in rest positions. Exporters also split
/// vertices where weights change, and write -0.0 on one side of a plane of symmetry; the surface of
/// the character is connected there.
std::vector<std::uint32_t> weld_surface(const SkinnedMesh& mesh);

/// Computes Tree::welded_vertices. Precondition: the places and the caller's vertices are in range.
void index_welded_vertices(Tree& tree);

}  // namespace pelt::detail

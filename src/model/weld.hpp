#pragma once

#include "skin/skinned_mesh.hpp"

#include <cstdint>
#include <vector>

namespace pelt::detail {

/// For each vertex [V] the lowest number among the vertices that are bit-identical to it in rest
/// position, influences and displacements. Exporters split vertices at seams of texture and
/// normals; such vertices are posed to the same bits, whatever the pose. O(V log V), whatever the
/// input.
std::vector<std::uint32_t> weld_vertices(const SkinnedMesh& mesh);

}  // namespace pelt::detail

#pragma once

#include "skin/skinned_mesh.hpp"

#include <cstdint>
#include <vector>

namespace pelt::detail {

/// Returns for each triangle [T] the joint with the largest sum of weights over the triangle's
/// vertices; of equal joints, the lowest. O(influences of all triangle vertices, times those of one
/// triangle).
std::vector<std::uint16_t> main_joints(const SkinnedMesh& mesh);

}  // namespace pelt::detail

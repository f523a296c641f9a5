#pragma once

#include "skin/skinned_mesh.hpp"

#include <cstdint>
#include <vector>

namespace pelt::detail {

/// [T] The joint that each triangle follows most: the largest sum of weights over the corners, the
/// lowest joint of equal ones. O(influences of all corners, times those of one).
std::vector<std::uint16_t> main_joints(const SkinnedMesh& mesh);

}  // namespace pelt::detail

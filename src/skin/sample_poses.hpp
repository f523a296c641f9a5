#pragma once

#include "skin/palette.hpp"
#include "skin/skinned_mesh.hpp"

#include <vector>

namespace pelt::detail {

/// Palettes to try bounds on when the caller has given none: each joint turns about the middle of
/// the vertices that it moves, by up to 45 degrees. Real skeletons move with more sense,
/// but what is tight here is tight there. The same on every machine.
std::vector<Palette> invent_sample_poses(const SkinnedMesh& mesh);

}  // namespace pelt::detail

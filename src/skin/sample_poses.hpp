#pragma once

#include "skin/palette.hpp"
#include "skin/skinned_mesh.hpp"

#include <vector>

namespace pelt::detail {

/// Generates palettes for choosing bounds if the caller gives none: each joint rotates about the
/// middle of the vertices that it moves, by up to 45 degrees. Real skeletons move differently, but
/// bounds that are tight here are tight there, too. The palettes are the same on every machine.
std::vector<Palette> invent_sample_poses(const SkinnedMesh& mesh);

}  // namespace pelt::detail

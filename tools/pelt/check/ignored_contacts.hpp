#pragma once

#include "scenes/ignored_pairs.hpp"
#include "tools/pelt/scene/scene_query.hpp"
#include "tools/pelt/scene/staged_scene.hpp"

#include <cstdint>
#include <span>

namespace pelt::tools::check {

/// Removes ignored contacts, and pairs of colliders without other contacts. Returns the number of
/// removed contacts. Precondition: `ignored` was made from the scene's characters.
std::uint64_t take_ignored_out(const scenes::IgnoredPairs& ignored,
                               const scene::StagedScene& staged, scene::FrameContacts& found);

}  // namespace pelt::tools::check

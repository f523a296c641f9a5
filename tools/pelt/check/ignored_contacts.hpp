#pragma once

#include "scenes/ignored_pairs.hpp"
#include "tools/pelt/scene/scene_query.hpp"
#include "tools/pelt/scene/staged_scene.hpp"

#include <cstdint>
#include <span>

namespace pelt::tools::check {

/// Takes the contacts out that do not count, and pairs of colliders that have no others; returns
/// how many contacts that were. `ignored` was made of the scene's characters.
std::uint64_t take_ignored_out(const scenes::IgnoredPairs& ignored,
                               const scene::StagedScene& staged, scene::FrameContacts& found);

}  // namespace pelt::tools::check

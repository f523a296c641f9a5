#pragma once

/// Typical poses of a character, from its own clips: what ModelOptions::sample_palettes wants.

#include "scenes/scene.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace pelt::scenes {

/// The clips that the instances of a character play, each once.
std::vector<const asset::Clip*> played_clips(const Scene& scene, std::uint32_t character);

/// The first `count` clips, or fewer where there are fewer.
std::vector<const asset::Clip*> first_clips(const asset::Asset& asset, std::uint32_t count);

/// The joint palettes of `count` poses, evenly over all clips laid end to end as if they took the
/// same time; none without clips.
std::vector<Matrix4> clip_samples(const asset::Asset& asset,
                                  std::span<const asset::Clip* const> clips, std::uint32_t count);

}  // namespace pelt::scenes

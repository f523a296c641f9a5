#pragma once

/// Typical poses of a character from its own clips, for ModelOptions::sample_palettes.

#include "scenes/scene.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace pelt::scenes {

/// Returns the clips that the instances of a character play, each once.
std::vector<const asset::Clip*> played_clips(const Scene& scene, std::uint32_t character);

/// Returns the first `count` clips, or all if there are fewer.
std::vector<const asset::Clip*> first_clips(const asset::Asset& asset, std::uint32_t count);

/// Returns the joint palettes of `count` poses, evenly spaced over all clips; each clip gets the
/// same number. Empty if there are no clips.
std::vector<Matrix4> clip_samples(const asset::Asset& asset,
                                  std::span<const asset::Clip* const> clips, std::uint32_t count);

}  // namespace pelt::scenes

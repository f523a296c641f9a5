#pragma once

/// Takes: ranges of frames in which instances that play all clips play one of them.

#include "scenes/scene.hpp"

#include <cstdint>
#include <string_view>

namespace pelt::scenes {

/// The clip of an instance that plays all clips of its character, one after the other.
inline constexpr std::string_view kAllClips = "*";

inline bool plays_all_clips(const Instance& instance) { return instance.clip == kAllClips; }

/// Returns an error for a character that has no clips, or two clips of one name. The message starts
/// with the character's name. O(clips log clips).
Result<void> check_all_clips(const Character& character);

/// Sets the takes and the number of frames of a scene in which an instance plays all clips. Does
/// nothing for other scenes. A take lasts as long as the longest clip that is played in it. Takes
/// are in the order of the clips of the first character that plays all of its clips.
///
/// Returns an error if characters that play all clips have clips of different names, or if there
/// are more than kMaxFrames frames. O(takes times instances times clips).
///
/// Precondition: `check_clip` accepts all instances.
Result<void> plan_takes(Scene& scene);

/// Returns the number of frames at `scene.fps` of the longest clip of the instances, at least 1 and
/// at most kMaxFrames. Instances that play all clips play `take`, which is null if there are none.
std::uint32_t frames_of_longest_clip(const Scene& scene, const Take* take = nullptr);

/// Returns the index of the take with this frame, or 0 if the scene has no takes. Frames after the
/// last take belong to it. O(log takes).
std::uint32_t take_index(const Scene& scene, std::uint32_t frame);

/// Returns the take with this frame, or null if the scene has no takes. O(log takes).
const Take* find_take(const Scene& scene, std::uint32_t frame);

/// Returns the number of a frame, counted from the first frame of its take if the scene has takes.
/// O(log takes).
std::uint32_t frame_in_take(const Scene& scene, std::uint32_t frame);

/// Returns the clip that an instance plays in `take`, or null for the default pose. O(clips).
const asset::Clip* clip_in(const Scene& scene, std::uint32_t instance, const Take* take);

}  // namespace pelt::scenes

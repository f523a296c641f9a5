#include "scenes/takes.hpp"

#include "base/assert.hpp"
#include "text/message.hpp"

#include <algorithm>
#include <cmath>

namespace pelt::scenes {
namespace {

const Character& character_of(const Scene& scene, const Instance& instance) {
  return scene.characters[instance.character];
}

std::vector<std::string> sorted_clip_names(const Character& character) {
  std::vector<std::string> names;
  for (const asset::Clip& clip : character.asset.clips) names.push_back(clip.name);
  std::sort(names.begin(), names.end());
  return names;
}

Error invalid(std::string message) { return {ErrorCode::invalid_argument, std::move(message)}; }

Result<void> check_same_clips(const Character& first, const Character& other) {
  if (sorted_clip_names(first) == sorted_clip_names(other)) return {};
  return invalid(text::quoted(first.name) + " and " + text::quoted(other.name) +
                 " have different clips, so \"*\" cannot play the clips of both: name one clip "
                 "for one of them");
}

/// Returns the character whose clips give the takes, or null if no instance plays all clips.
Result<const Character*> leading_character(const Scene& scene) {
  const Character* first = nullptr;
  for (const Instance& instance : scene.instances) {
    if (!plays_all_clips(instance)) continue;
    const Character& character = character_of(scene, instance);
    if (first == nullptr) first = &character;
    if (const auto same = check_same_clips(*first, character); !same) return same.error();
  }
  return first;
}

}  // namespace

Result<void> check_all_clips(const Character& character) {
  const std::vector<std::string> names = sorted_clip_names(character);
  const std::string name = text::quoted(character.name);
  if (names.empty()) return invalid(name + " has no clips, so \"*\" has nothing to play");
  const auto twice = std::adjacent_find(names.begin(), names.end());
  if (twice == names.end()) return {};
  return invalid(name + " has several clips named " + text::quoted(*twice) +
                 ", which \"*\" cannot tell apart: give each clip its own name");
}

Result<void> plan_takes(Scene& scene) {
  const Result<const Character*> leading = leading_character(scene);
  if (!leading) return leading.error();
  scene.takes.clear();
  if (*leading == nullptr) return {};
  std::uint64_t frames = 0;
  for (const asset::Clip& clip : (*leading)->asset.clips) {
    Take take = {clip.name, static_cast<std::uint32_t>(frames), 0};
    take.frame_count = frames_of_longest_clip(scene, &take);
    frames += take.frame_count;
    if (frames > kMaxFrames)
      return invalid("all clips together have more than " + std::to_string(kMaxFrames) +
                     " frames: lower the frame rate");
    scene.takes.push_back(std::move(take));
  }
  scene.frame_count = static_cast<std::uint32_t>(frames);
  return {};
}

std::uint32_t frames_of_longest_clip(const Scene& scene, const Take* take) {
  double longest = 0;
  for (std::uint32_t i = 0; i < scene.instances.size(); ++i) {
    if (const asset::Clip* clip = clip_in(scene, i, take))
      longest = std::max(longest, static_cast<double>(clip->duration));
  }
  return static_cast<std::uint32_t>(
      std::clamp(std::ceil(longest * scene.fps), 1.0, double{kMaxFrames}));
}

std::uint32_t take_index(const Scene& scene, std::uint32_t frame) {
  if (scene.takes.empty()) return 0;
  const auto next = std::upper_bound(
      scene.takes.begin() + 1, scene.takes.end(), frame,
      [](std::uint32_t value, const Take& take) { return value < take.first_frame; });
  return static_cast<std::uint32_t>(next - scene.takes.begin() - 1);
}

const Take* find_take(const Scene& scene, std::uint32_t frame) {
  return scene.takes.empty() ? nullptr : &scene.takes[take_index(scene, frame)];
}

std::uint32_t frame_in_take(const Scene& scene, std::uint32_t frame) {
  const Take* take = find_take(scene, frame);
  return take == nullptr ? frame : frame - take->first_frame;
}

const asset::Clip* clip_in(const Scene& scene, std::uint32_t instance, const Take* take) {
  const Instance& one = scene.instances[instance];
  if (!one.clip) return nullptr;
  const bool plays_all = plays_all_clips(one);
  PELT_ASSERT(!plays_all || take != nullptr);
  const asset::Clip* clip =
      character_of(scene, one).asset.find_clip(plays_all ? take->clip : *one.clip);
  PELT_ASSERT(clip != nullptr);
  return clip;
}

}  // namespace pelt::scenes

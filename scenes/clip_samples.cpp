#include "scenes/clip_samples.hpp"

#include "scenes/takes.hpp"

#include <algorithm>

namespace pelt::scenes {

std::vector<const asset::Clip*> played_clips(const Scene& scene, std::uint32_t character) {
  const asset::Asset& asset = scene.characters[character].asset;
  std::vector<const asset::Clip*> clips;
  const auto add = [&](const asset::Clip* clip) {
    if (std::find(clips.begin(), clips.end(), clip) == clips.end()) clips.push_back(clip);
  };
  for (const Instance& instance : scene.instances) {
    if (instance.character != character || !instance.clip) continue;
    if (plays_all_clips(instance))
      for (const asset::Clip& clip : asset.clips) add(&clip);
    else
      add(asset.find_clip(*instance.clip));
  }
  return clips;
}

std::vector<const asset::Clip*> first_clips(const asset::Asset& asset, std::uint32_t count) {
  std::vector<const asset::Clip*> clips;
  for (const asset::Clip& clip : asset.clips)
    if (clips.size() < count) clips.push_back(&clip);
  return clips;
}

std::vector<Matrix4> clip_samples(const asset::Asset& asset,
                                  std::span<const asset::Clip* const> clips, std::uint32_t count) {
  if (clips.empty()) return {};
  const std::size_t joints = asset.joints.size();
  std::vector<Matrix4> palettes(count * joints);
  asset::SampleScratch scratch;
  const std::uint64_t parts = 2 * std::uint64_t{count};  // of a clip; samples are at odd ones
  for (std::uint64_t sample = 0; sample < count; ++sample) {
    const std::uint64_t place = (2 * sample + 1) * clips.size();
    const asset::Clip& clip = *clips[place / parts];
    const double share = static_cast<double>(place % parts) / static_cast<double>(parts);
    const auto seconds = static_cast<float>(share * static_cast<double>(clip.duration));
    asset::sample_palette(asset, &clip, seconds, {}, scratch,
                          std::span(palettes).subspan(sample * joints, joints));
  }
  return palettes;
}

}  // namespace pelt::scenes

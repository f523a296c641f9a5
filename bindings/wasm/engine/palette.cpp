/// Samples joint palettes and morph weights from clips.

#include "bindings/wasm/engine/export.hpp"
#include "bindings/wasm/engine/handles.hpp"
#include "pose/pose.hpp"

#include <cmath>
#include <cstddef>

namespace pelt::wasm {
namespace {

/// An instance, validated and written by JavaScript.
struct PlacedNumbers {
  double clip;  ///< index of the clip; -1: none
  double start, speed;
  std::array<double, 3> translation;
  std::array<double, 4> rotation;
  double scale;
  std::array<double, 3> velocity;
};
static_assert(sizeof(PlacedNumbers) == 14 * sizeof(double) &&
                  offsetof(PlacedNumbers, start) == 1 * sizeof(double) &&
                  offsetof(PlacedNumbers, speed) == 2 * sizeof(double) &&
                  offsetof(PlacedNumbers, translation) == 3 * sizeof(double) &&
                  offsetof(PlacedNumbers, rotation) == 6 * sizeof(double) &&
                  offsetof(PlacedNumbers, scale) == 10 * sizeof(double) &&
                  offsetof(PlacedNumbers, velocity) == 11 * sizeof(double),
              "JavaScript writes 14 numbers in this order (scene.mjs)");

/// `kept` are fixed morph weights; NaN means the clip's weight.
scenes::Instance to_instance(const asset::Asset& asset, const PlacedNumbers& numbers,
                             std::span<const float> kept) {
  scenes::Instance instance;
  if (numbers.clip >= 0) instance.clip = asset.clips[static_cast<std::size_t>(numbers.clip)].name;
  instance.start = numbers.start;
  instance.speed = numbers.speed;
  instance.translation = numbers.translation;
  instance.rotation = numbers.rotation;
  instance.scale = numbers.scale;
  instance.velocity = numbers.velocity;
  for (std::uint32_t m = 0; m < kept.size(); ++m)
    if (!std::isnan(kept[m])) instance.morph_weights.push_back({m, kept[m]});
  return instance;
}

/// Palettes and weights, which JavaScript may read.
struct Sampled {
  std::vector<Matrix4> palette;
  std::vector<float> weights;
};

Sampled& sampled() {
  static Sampled sampled;
  return sampled;
}

Sampled& sampled_of(const asset::Asset& asset) {
  sampled().palette.resize(asset.joints.size());
  sampled().weights.resize(asset.morph_targets.size());
  return sampled();
}

const asset::Clip* clip_of(const asset::Asset& asset, std::int32_t clip) {
  return clip < 0 ? nullptr : &asset.clips[static_cast<std::size_t>(clip)];
}

/// Sets palette and weights, or neither: sets them in a copy first.
Result<void> take(PoseHandle& handle, const Sampled& sampled) {
  handle.moved();
  if (!sampled.weights.empty()) {
    detail::Palette tried = handle.pose.detail().palette;
    if (Result<void> set = tried.set_morph_weights(sampled.weights); !set) return set;
    if (Result<void> set = tried.set(sampled.palette); !set) return set;
    (void)handle.pose.set_morph_weights(sampled.weights);
  }
  return handle.pose.set_palette(sampled.palette);
}

}  // namespace

void sample_palette(const CharacterHandle& handle, std::int32_t clip, float seconds,
                    std::span<const Matrix4> placement) {
  const asset::Asset& asset = handle.character->asset();
  std::vector<Matrix4>& palette = sampled_of(asset).palette;
  asset::sample_palette(asset, clip_of(asset, clip), seconds, placement[0], sample_scratch(),
                        palette);
  answer_arrays(palette);
}
PELT_EXPORT(sample_palette)

void sample_morph_weights(const CharacterHandle& handle, std::int32_t clip, float seconds) {
  const asset::Asset& asset = handle.character->asset();
  std::vector<float>& weights = sampled_of(asset).weights;
  asset::sample_morph_weights(asset, clip_of(asset, clip), seconds, weights);
  answer_arrays(weights);
}
PELT_EXPORT(sample_morph_weights)

void instance_palette(const CharacterHandle& handle, double seconds,
                      std::span<const PlacedNumbers> placed, std::span<const float> kept) {
  const asset::Asset& asset = handle.character->asset();
  std::vector<Matrix4>& palette = sampled_of(asset).palette;
  scenes::instance_palette(asset, to_instance(asset, placed[0], kept), seconds, sample_scratch(),
                           palette);
  answer_arrays(palette);
}
PELT_EXPORT(instance_palette)

void instance_morph_weights(const CharacterHandle& handle, double seconds,
                            std::span<const PlacedNumbers> placed, std::span<const float> kept) {
  const asset::Asset& asset = handle.character->asset();
  std::vector<float>& weights = sampled_of(asset).weights;
  scenes::instance_morph_weights(asset, to_instance(asset, placed[0], kept), seconds, weights);
  answer_arrays(weights);
}
PELT_EXPORT(instance_morph_weights)

/// Poses an instance without passing its palette through JavaScript.
Result<void> pose_instance(PoseHandle& handle, double seconds,
                           std::span<const PlacedNumbers> placed, std::span<const float> kept) {
  const asset::Asset& asset = handle.character->asset();
  const scenes::Instance instance = to_instance(asset, placed[0], kept);
  Sampled& sampled = sampled_of(asset);
  scenes::instance_palette(asset, instance, seconds, sample_scratch(), sampled.palette);
  scenes::instance_morph_weights(asset, instance, seconds, sampled.weights);
  return in_words_of_javascript(take(handle, sampled));
}
PELT_EXPORT(pose_instance)

}  // namespace pelt::wasm

/// Samples joint palettes and morph weights from clips directly into a pose's memory.

#include "bindings/wasm/engine/answer.hpp"
#include "bindings/wasm/engine/handles.hpp"
#include "pose/pose.hpp"

#include <cmath>
#include <cstddef>
#include <cstring>

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

/// Memory where JavaScript writes fixed morph weights; NaN means the clip's weight.
std::vector<float>& kept_weights() {
  static std::vector<float> weights;
  return weights;
}

scenes::Instance to_instance(const asset::Asset& asset, const PlacedNumbers& numbers) {
  scenes::Instance instance;
  if (numbers.clip >= 0) instance.clip = asset.clips[static_cast<std::size_t>(numbers.clip)].name;
  instance.start = numbers.start;
  instance.speed = numbers.speed;
  instance.translation = numbers.translation;
  instance.rotation = numbers.rotation;
  instance.scale = numbers.scale;
  instance.velocity = numbers.velocity;
  for (std::uint32_t m = 0; m < kept_weights().size(); ++m)
    if (!std::isnan(kept_weights()[m])) instance.morph_weights.push_back({m, kept_weights()[m]});
  return instance;
}

/// Memory where JavaScript reads palettes and weights that belong to no pose.
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

/// Sets both or neither: tries them on a copy first.
Result<void> take(PoseHandle& handle) {
  handle.moved();
  if (!handle.morphs.empty()) {
    detail::Palette tried = handle.pose.detail().palette;
    if (Result<void> set = tried.set_morph_weights(handle.morphs); !set) return set;
    if (Result<void> set = tried.set(handle.palette); !set) return set;
    (void)handle.pose.set_morph_weights(handle.morphs);
  }
  return handle.pose.set_palette(handle.palette);
}

}  // namespace

/// Returns memory of 16 floats where JavaScript writes a placement.
PELT_EXPORT float* pelt_placement() {
  static Matrix4 placement;
  return placement.m.data();
}

PELT_EXPORT void pelt_sample_palette(const CharacterHandle* handle, std::int32_t clip,
                                     float seconds) {
  const asset::Asset& asset = handle->character->asset();
  Matrix4 placement;
  std::memcpy(placement.m.data(), pelt_placement(), sizeof(placement));
  std::vector<Matrix4>& palette = sampled_of(asset).palette;
  asset::sample_palette(asset, clip_of(asset, clip), seconds, placement, sample_scratch(), palette);
  answer_data<Matrix4>(palette);
}

PELT_EXPORT void pelt_sample_morph_weights(const CharacterHandle* handle, std::int32_t clip,
                                           float seconds) {
  const asset::Asset& asset = handle->character->asset();
  std::vector<float>& weights = sampled_of(asset).weights;
  asset::sample_morph_weights(asset, clip_of(asset, clip), seconds, weights);
  answer_data<float>(weights);
}

/// Returns memory where JavaScript writes an instance.
PELT_EXPORT PlacedNumbers* pelt_instance() {
  static PlacedNumbers numbers;
  return &numbers;
}

PELT_EXPORT float* pelt_kept_weights(std::uint32_t count) {
  kept_weights().resize(count);
  return kept_weights().data();
}

PELT_EXPORT void pelt_instance_palette(const CharacterHandle* handle, double seconds) {
  const asset::Asset& asset = handle->character->asset();
  std::vector<Matrix4>& palette = sampled_of(asset).palette;
  scenes::instance_palette(asset, to_instance(asset, *pelt_instance()), seconds, sample_scratch(),
                           palette);
  answer_data<Matrix4>(palette);
}

PELT_EXPORT void pelt_instance_morph_weights(const CharacterHandle* handle, double seconds) {
  const asset::Asset& asset = handle->character->asset();
  std::vector<float>& weights = sampled_of(asset).weights;
  scenes::instance_morph_weights(asset, to_instance(asset, *pelt_instance()), seconds, weights);
  answer_data<float>(weights);
}

/// Poses an instance without passing its palette through JavaScript.
PELT_EXPORT std::uint32_t pelt_pose_instance(PoseHandle* handle, double seconds) {
  const asset::Asset& asset = handle->character->asset();
  const scenes::Instance instance = to_instance(asset, *pelt_instance());
  scenes::instance_palette(asset, instance, seconds, sample_scratch(), handle->palette);
  scenes::instance_morph_weights(asset, instance, seconds, handle->morphs);
  return done(take(*handle));
}

}  // namespace pelt::wasm

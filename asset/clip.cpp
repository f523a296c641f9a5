#include <pelt/asset.hpp>

#include "asset/affine.hpp"
#include "asset/channel.hpp"
#include "base/assert.hpp"

#include <algorithm>
#include <cstddef>

namespace pelt::asset {
namespace {

using Local = SampleScratch::Local;

Local default_local(const Transform& transform) {
  Local local;
  for (std::size_t i = 0; i < 3; ++i) local.translation[i] = transform.translation[i];
  for (std::size_t i = 0; i < 4; ++i) local.rotation[i] = transform.rotation[i];
  for (std::size_t i = 0; i < 3; ++i) local.scale[i] = transform.scale[i];
  return local;
}

void apply(const Channel& channel, float seconds, Local& local) {
  const std::array<double, 4> value = sample_channel(channel, seconds);
  switch (channel.path) {
    case Path::translation:
      local.translation = {value[0], value[1], value[2]};
      break;
    case Path::rotation:
      local.rotation = value;
      break;
    case Path::scale:
      local.scale = {value[0], value[1], value[2]};
      break;
    case Path::weights:
      break;
  }
}

void sample_locals(const Asset& asset, const Clip* clip, float seconds, SampleScratch& scratch) {
  scratch.locals.resize(asset.nodes.size());
  for (std::size_t n = 0; n < asset.nodes.size(); ++n) {
    scratch.locals[n] = default_local(asset.nodes[n].local);
  }
  if (clip == nullptr) return;
  for (const Channel& channel : clip->channels) {
    PELT_ASSERT(channel.node < asset.nodes.size());
    if (channel.path != Path::weights) apply(channel, seconds, scratch.locals[channel.node]);
  }
}

Affine local_affine(const Node& node, const Local& local) {
  if (node.has_matrix) return affine_of(node.matrix);
  const auto& r = local.rotation;
  return compose(local.translation, {r[0], r[1], r[2], r[3]}, local.scale);
}

void compute_globals(const Asset& asset, const Matrix4& placement, SampleScratch& scratch) {
  const Affine root = affine_of(placement);
  scratch.globals.resize(asset.nodes.size());
  for (std::size_t n = 0; n < asset.nodes.size(); ++n) {
    const Node& node = asset.nodes[n];
    PELT_ASSERT(node.parent == kNoParent || node.parent < n);
    const Affine& parent = node.parent == kNoParent ? root : scratch.globals[node.parent];
    scratch.globals[n] = parent * local_affine(node, scratch.locals[n]);
  }
}

}  // namespace

void sample_palette(const Asset& asset, const Clip* clip, float seconds, const Matrix4& placement,
                    SampleScratch& scratch, std::span<Matrix4> palette) {
  PELT_ASSERT(palette.size() == asset.joints.size());
  sample_locals(asset, clip, seconds, scratch);
  compute_globals(asset, placement, scratch);
  for (std::size_t j = 0; j < asset.joints.size(); ++j) {
    const Joint& joint = asset.joints[j];
    palette[j] = matrix_of(scratch.globals[joint.node] * affine_of(joint.inverse_bind));
  }
}

void sample_morph_weights(const Asset& asset, const Clip* clip, float seconds,
                          std::span<float> weights) {
  const std::vector<MorphTarget>& targets = asset.morph_targets;
  PELT_ASSERT(weights.size() == targets.size());
  for (std::size_t m = 0; m < targets.size(); ++m) weights[m] = targets[m].default_weight;
  if (clip == nullptr) return;
  for (const Channel& channel : clip->channels) {
    if (channel.path != Path::weights) continue;
    const auto is_of_node = [&](const MorphTarget& t) { return t.node == channel.node; };
    const auto first = std::find_if(targets.begin(), targets.end(), is_of_node);
    const auto last = std::find_if_not(first, targets.end(), is_of_node);
    sample_weights(channel, seconds,
                   weights.subspan(static_cast<std::size_t>(first - targets.begin()),
                                   static_cast<std::size_t>(last - first)));
  }
}

}  // namespace pelt::asset

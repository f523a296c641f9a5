#include "asset/clip.hpp"

#include <pelt/asset.hpp>

#include "asset/transform.hpp"
#include "base/assert.hpp"

#include <algorithm>
#include <cstddef>

namespace pelt::asset {
namespace {

using Value = std::array<double, 4>;
using Local = SampleScratch::Local;

enum KeyPart { in_tangent, value, out_tangent };

/// Number i of a value or tangent of `size` numbers.
double number(const Channel& channel, std::size_t size, std::size_t i, std::size_t key,
              KeyPart part) {
  const bool cubic = channel.interpolation == Interpolation::cubic_spline;
  return channel.values[size * (cubic ? 3 * key + part : key) + i];
}

Value key_part(const Channel& channel, std::size_t key, KeyPart part) {
  const std::size_t size = value_size(channel.path);
  Value result = {};
  for (std::size_t i = 0; i < size; ++i) result[i] = number(channel, size, i, key, part);
  return result;
}

Quaternion quaternion(const Value& v) { return {v[0], v[1], v[2], v[3]}; }
Value numbers(const Quaternion& q) { return {q.x, q.y, q.z, q.w}; }

Value linear(const Channel& channel, std::size_t key, double t) {
  const Value a = key_part(channel, key, value);
  const Value b = key_part(channel, key + 1, value);
  if (channel.path == Path::rotation) return numbers(slerp(quaternion(a), quaternion(b), t));
  Value result;
  for (std::size_t i = 0; i < 4; ++i) result[i] = a[i] * (1 - t) + b[i] * t;
  return result;
}

double hermite(double a, double leaving_a, double entering_b, double b, double t, double interval) {
  const double t2 = t * t, t3 = t2 * t;
  const double values = (2 * t3 - 3 * t2 + 1) * a + (3 * t2 - 2 * t3) * b;
  const double tangents = (t3 - 2 * t2 + t) * leaving_a + (t3 - t2) * entering_b;
  return values + interval * tangents;
}

Value cubic_spline(const Channel& channel, std::size_t key, double t, double interval) {
  const Value a = key_part(channel, key, value);
  const Value leaving_a = key_part(channel, key, out_tangent);
  const Value entering_b = key_part(channel, key + 1, in_tangent);
  const Value b = key_part(channel, key + 1, value);
  Value result;
  for (std::size_t i = 0; i < 4; ++i)
    result[i] = hermite(a[i], leaving_a[i], entering_b[i], b[i], t, interval);
  if (channel.path == Path::rotation) return numbers(normalised(quaternion(result)));
  return result;
}

/// The position of a time between keys; exactly at `key` if `t` is 0.
struct KeyTime {
  std::size_t key;
  double t, interval;
};

KeyTime key_time(const std::vector<float>& times, float seconds) {
  PELT_ASSERT(!times.empty());
  if (!(seconds > times.front())) return {0, 0, 0};
  if (seconds >= times.back()) return {times.size() - 1, 0, 0};
  const auto next = std::upper_bound(times.begin(), times.end(), seconds);
  const std::size_t key = static_cast<std::size_t>(next - times.begin()) - 1;
  const double interval = double{times[key + 1]} - double{times[key]};
  return {key, (double{seconds} - double{times[key]}) / interval, interval};
}

double sample_weight(const Channel& channel, std::size_t count, std::size_t i, const KeyTime& at) {
  const auto part = [&](std::size_t key, KeyPart p) { return number(channel, count, i, key, p); };
  const double a = part(at.key, value);
  if (at.t == 0 || channel.interpolation == Interpolation::step) return a;
  const double b = part(at.key + 1, value);
  if (channel.interpolation == Interpolation::linear) return a * (1 - at.t) + b * at.t;
  return hermite(a, part(at.key, out_tangent), part(at.key + 1, in_tangent), b, at.t, at.interval);
}

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

std::array<double, 4> sample_channel(const Channel& channel, float seconds) {
  const auto [key, t, interval] = key_time(channel.times, seconds);
  if (t == 0 || channel.interpolation == Interpolation::step) return key_part(channel, key, value);
  return channel.interpolation == Interpolation::linear ? linear(channel, key, t)
                                                        : cubic_spline(channel, key, t, interval);
}

void sample_weights(const Channel& channel, float seconds, std::span<float> out) {
  const KeyTime at = key_time(channel.times, seconds);
  for (std::size_t i = 0; i < out.size(); ++i)
    out[i] = static_cast<float>(sample_weight(channel, out.size(), i, at));
}

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

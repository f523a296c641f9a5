#include "scenes/creature/talk.hpp"

#include "asset/transform.hpp"
#include "scenes/creature/expressions.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace pelt::scenes {
namespace {

using asset::cosine_of_turns;
using asset::Quaternion;
using asset::sine_of_turns;

constexpr int kKeys = 48;
constexpr double kSeconds = 4;

Quaternion turn(const Vec3d& axis, double turns) {
  const double s = sine_of_turns(turns / 2);
  return {axis.x * s, axis.y * s, axis.z * s, cosine_of_turns(turns / 2)};
}

/// 1 at the phase `when`, 0 at 0.05 or more before and after it.
double pulse(double phase, double when) {
  return std::max(0.0, 1 - std::fabs(phase - when) / 0.05);
}

/// The positive half of a wave; 0 in the negative half.
double wave(double turns) { return std::max(0.0, sine_of_turns(turns)); }

std::array<double, kExpressions> weights_at(double phase) {
  std::array<double, kExpressions> weights = {};
  const double both = pulse(phase, 0.2) + pulse(phase, 0.7);
  weights[kJawOpen] = wave(6 * phase) * wave(phase + 0.1);
  weights[kSmile] = wave(phase - 0.35);
  weights[kBlinkLeft] = both;
  weights[kBlinkRight] = both + pulse(phase, 0.45);
  weights[kBrowsUp] = 0.8 * wave(2 * phase + 0.1);
  weights[kCheeksPuffed] = 0.7 * wave(phase - 0.6);
  return weights;
}

Quaternion rotation_at(const std::string& joint, double phase) {
  if (joint == "neck_1") return turn({0, 1, 0}, 0.03 * sine_of_turns(phase));
  if (joint == "neck_2") return turn({0, 0, 1}, 0.02 * sine_of_turns(phase + 0.2));
  if (joint == "head")
    return turn({1, 0, 0}, 0.02 * sine_of_turns(2 * phase)) *
           turn({0, 1, 0}, 0.03 * sine_of_turns(phase - 0.1));
  const double side = joint.ends_with("_l") ? 1 : -1;  // an ear
  return turn({0, 0, 1}, side * 0.03 * cosine_of_turns(2 * phase));
}

/// The last key repeats the first, so that the clip is a loop.
template <typename ValuesAt>
asset::Channel make_channel(std::uint32_t node, asset::Path path, const ValuesAt& values_at) {
  asset::Channel channel = {node, path, asset::Interpolation::linear, {}, {}};
  for (int k = 0; k <= kKeys; ++k) {
    channel.times.push_back(static_cast<float>(kSeconds * k / kKeys));
    for (const double value : values_at((k % kKeys) / double{kKeys}))
      channel.values.push_back(static_cast<float>(value));
  }
  return channel;
}

}  // namespace

asset::Clip talk_clip(const BodyPlan& bust, std::span<const std::uint32_t> nodes) {
  asset::Clip clip = {"talk", static_cast<float>(kSeconds), {}};
  for (std::size_t j = 0; j < nodes.size(); ++j) {
    if (nodes[j] == kNone) continue;
    clip.channels.push_back(make_channel(nodes[j], asset::Path::rotation, [&](double phase) {
      const Quaternion q = rotation_at(bust.joints[j].name, phase);
      return std::array<double, 4>{q.x, q.y, q.z, q.w};
    }));
  }
  clip.channels.push_back(make_channel(0, asset::Path::weights, weights_at));
  return clip;
}

}  // namespace pelt::scenes

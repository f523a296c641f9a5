#include "scenes/creature/expressions.hpp"

#include "asset/transform.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace pelt::scenes {
namespace {

using asset::cosine_of_turns;
using asset::Quaternion;
using asset::sine_of_turns;

/// 1 at 0, decreasing smoothly to 0 at 1.
double fade(double x) {
  const double t = std::min(1.0, x);
  return (1 - t) * (1 - t) * (1 + 2 * t);
}

/// Pulls the skin around `centre` along `by`.
Vec3d pull(const Vec3d& point, const Vec3d& centre, double radius, const Vec3d& by) {
  return fade(length(point - centre) / radius) * by;
}

/// The same on both sides.
Vec3d pull_both(const HeadFrame& head, const Vec3d& point, const Vec3d& centre, double radius,
                const Vec3d& by) {
  Vec3d sum;
  for (const double side : {1.0, -1.0})
    sum = sum + pull(point, head.at(side * centre.x, centre.y, centre.z), radius * head.scale,
                     head.scale * Vec3d(side * by.x, by.y, by.z));
  return sum;
}

Vec3d blink(const HeadFrame& head, const Vec3d& point, double side) {
  return pull(point, head.at(side * 0.064, 0.18, 0.15), 0.06 * head.scale,
              head.scale * Vec3d(0, -0.03, -0.02));
}

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

Expressions::Expressions(const BodyPlan& bust) : bust_(bust), jaw_(find_joint(bust, "jaw")) {}

Vec3d Expressions::displacement(Expression expression, const Vec3d& point) const {
  const HeadFrame& head = bust_.head;
  switch (expression) {
    case kJawOpen:
      return open_jaw(point);
    case kSmile:
      return pull_both(head, point, {0.07, 0.05, head.snout - 0.02}, 0.09, {0.025, 0.045, -0.02});
    case kBlinkLeft:
      return blink(head, point, 1);
    case kBlinkRight:
      return blink(head, point, -1);
    case kBrowsUp:
      return pull_both(head, point, {0.05, 0.22, 0.10}, 0.09, {0, 0.04, 0.01});
    case kCheeksPuffed:
      return pull_both(head, point, {0.12, 0.08, 0.06}, 0.10, {0.06, 0, 0.02});
    case kExpressions:
      break;
  }
  return {};
}

/// Rotates about the jaw's joint, in proportion to how much nearer a point is to the jaw than to
/// the rest.
Vec3d Expressions::open_jaw(const Vec3d& point) const {
  constexpr double kTurns = 0.07;
  double jaw = std::numeric_limits<double>::infinity(), rest = jaw;
  for (const Limb& limb : bust_.flesh.limbs)
    for (const Muscle& muscle : limb.muscles) {
      double& least = muscle.joint == jaw_ ? jaw : rest;
      least = std::min(least, muscle_distance(muscle, point));
    }
  const double width = 0.03 * bust_.head.scale;
  const double share = fade(std::max(0.0, (jaw - rest) / width + 0.5));
  const asset::Quaternion turn = {asset::sine_of_turns(kTurns / 2), 0, 0,
                                  asset::cosine_of_turns(kTurns / 2)};
  const Vec3d from_hinge = point - bust_.joints[jaw_].position;
  return share * (rotate(turn, from_hinge) - from_hinge);
}

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

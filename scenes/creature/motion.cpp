#include "scenes/creature/motion.hpp"

#include "scenes/creature.hpp"
#include "scenes/creature/posture.hpp"

#include <algorithm>
#include <string>

namespace pelt::scenes {
namespace {

using asset::cosine_of_turns;
using asset::sine_of_turns;

constexpr int kWalkKeys = 48;
constexpr int kIdleKeys = 60;
constexpr double kIdleSeconds = 4;
constexpr double kStance = 0.6;  // fraction of the cycle in which a foot is on the ground

Quaternion turn(const Vec3d& axis, double turns) {
  const double s = sine_of_turns(turns / 2);
  return {axis.x * s, axis.y * s, axis.z * s, cosine_of_turns(turns / 2)};
}

const Vec3d kX(1, 0, 0), kY(0, 1, 0), kZ(0, 0, 1);

double smooth_step(double t) { return t * t * (3 - 2 * t); }

/// Collects a posture joint by joint.
class Puppet {
 public:
  explicit Puppet(const BodyPlan& plan) : plan_(plan) { posture_.local.resize(plan.joints.size()); }

  void set(const std::string& name, const Quaternion& rotation) {
    posture_.local[find_joint(plan_, name)] = rotation;
  }

  Posture& posture() { return posture_; }

 private:
  const BodyPlan& plan_;
  Posture posture_;
};

struct Side {
  std::string suffix;
  double sign;  ///< sign of x
};
const Side kSides[] = {{"_l", 1}, {"_r", -1}};

/// Relaxed fingers: curled about the axis across the palm.
void curl_hand(const Side& side, double turns, Puppet& puppet) {
  for (const char* finger : {"index_", "middle_", "little_"}) {
    for (int s = 1; s <= 3; ++s) {
      puppet.set(finger + std::to_string(s) + side.suffix, turn(kZ, -side.sign * turns));
    }
  }
  for (int s = 1; s <= 2; ++s) {
    puppet.set("thumb_" + std::to_string(s) + side.suffix, turn(kZ, -side.sign * 0.4 * turns));
  }
}

/// Lets the arm hang from the shoulder, swung forwards by `swing` turns, with the elbow bent by
/// `elbow`.
void hang_arm(const Side& side, double swing, double elbow, Puppet& puppet) {
  puppet.set("clavicle" + side.suffix, turn(kZ, -side.sign * 0.012) * turn(kX, -0.15 * swing));
  puppet.set("upper_arm" + side.suffix, turn(kX, -0.85 * swing) * turn(kZ, -side.sign * 0.036));
  puppet.set("fore_arm" + side.suffix, turn(unit({1, side.sign * 0.5, 0}), -elbow));
  puppet.set("hand" + side.suffix, turn(kZ, -side.sign * 0.015));
  curl_hand(side, 0.045, puppet);
}

/// A wave that runs along the tail.
void wave_tail(double phase, double amplitude, Puppet& puppet) {
  for (int s = 1; s <= 8; ++s) {
    puppet.set("tail_" + std::to_string(s),
               turn(kY, amplitude * sine_of_turns(phase - 0.07 * s)) *
                   turn(kX, 0.25 * amplitude * cosine_of_turns(2 * phase - 0.07 * s)));
  }
}

/// The target of a walking foot at a point of its cycle: on the ground while `progress` < kStance.
FootTarget walking_foot(double progress, double stride) {
  FootTarget target;
  const double swing = (progress - kStance) / (1 - kStance);
  if (swing < 0) {
    target.offset.z = stride * (0.5 - progress / kStance);
    const double strike = std::max(0.0, 1 - progress / 0.12);
    const double push = std::max(0.0, (progress - 0.36) / (kStance - 0.36));
    target.pitch = 0.095 * smooth_step(push) - 0.045 * smooth_step(strike);
  } else {
    // A cubic that leaves and reaches the ground at the speed of the ground.
    const double slope = -(1 - kStance) / kStance, t = swing;
    const double way = -0.5 * (2 * t * t * t - 3 * t * t + 1) + 0.5 * (3 * t * t - 2 * t * t * t) +
                       slope * (t * t * t - 2 * t * t + t) + slope * (t * t * t - t * t);
    target.offset.z = stride * way;
    target.offset.y = 0.30 * stride * t * (1 - t) * (1 - 0.35 * t);
    target.pitch = 0.095 + (-0.045 - 0.095) * smooth_step(t);
  }
  const double lift = std::max(0.0, target.pitch);
  target.toe_bend = swing < 0 ? lift : lift * (1 - smooth_step(swing));
  return target;
}

double stride_of(const BodyPlan& plan) { return 0.62 * plan.joints[0].position.y; }

double walk_seconds(const BodyPlan& plan) { return stride_of(plan) / (kStance * kWalkSpeed); }

Posture walk_posture(const BodyPlan& plan, double phase) {
  const double height = plan.joints[0].position.y;
  const double reach = cosine_of_turns(phase);       // 1: left foot foremost
  const double bounce = cosine_of_turns(2 * phase);  // 1: both feet on the ground
  const double sway = sine_of_turns(phase);          // 1: weight on the left foot
  Puppet puppet(plan);
  puppet.posture().hips_offset = {0.028 * sway, -height * (0.044 + 0.014 * bounce), 0};
  puppet.set("hips", turn(kY, -0.022 * reach) * turn(kZ, 0.008 * sway) * turn(kX, 0.006));
  for (const char* name : {"spine_1", "spine_2", "chest"}) {
    puppet.set(name, turn(kY, 0.017 * reach) * turn(kZ, -0.0045 * sway) *
                         turn(kX, 0.003 + 0.002 * bounce));
  }
  puppet.set("neck_1", turn(kY, -0.010 * reach) * turn(kX, -0.004));
  puppet.set("neck_2", turn(kY, -0.010 * reach) * turn(kX, -0.004));
  puppet.set("head", turn(kY, -0.010 * reach) * turn(kX, -0.006 * bounce) * turn(kZ, 0.006 * sway));
  puppet.set("jaw", turn(kX, 0.010 + 0.008 * cosine_of_turns(2 * phase - 0.1)));
  wave_tail(phase, 0.022, puppet);
  for (const Side& side : kSides) {
    const double swing = -side.sign * reach;
    hang_arm(side, 0.075 * swing, 0.065 + 0.035 * swing, puppet);
    const double flap = cosine_of_turns(2 * phase - 0.15);
    puppet.set("ear_1" + side.suffix, turn(kZ, side.sign * 0.015 * flap));
    puppet.set("ear_2" + side.suffix, turn(kZ, side.sign * 0.03 * flap));
  }
  const double stride = stride_of(plan);
  const double other = phase < 0.5 ? phase + 0.5 : phase - 0.5;
  place_feet(plan, {walking_foot(phase, stride), walking_foot(other, stride)}, puppet.posture());
  return puppet.posture();
}

Posture idle_posture(const BodyPlan& plan, double phase) {
  const double height = plan.joints[0].position.y;
  const double breath = sine_of_turns(2 * phase), sway = sine_of_turns(phase);
  Puppet puppet(plan);
  puppet.posture().hips_offset = {0.015 * sway, -height * (0.022 + 0.003 * breath), 0};
  puppet.set("hips", turn(kZ, 0.004 * sway));
  for (const char* name : {"spine_1", "spine_2", "chest"}) {
    puppet.set(name, turn(kX, -0.0025 * breath) * turn(kZ, -0.003 * sway));
  }
  for (const char* name : {"neck_1", "neck_2", "head"}) {
    puppet.set(name, turn(kY, 0.028 * sine_of_turns(phase - 0.1)) * turn(kX, 0.003 * breath));
  }
  puppet.set("jaw", turn(kX, 0.008 + 0.006 * breath));
  wave_tail(phase, 0.03, puppet);
  for (const Side& side : kSides) {
    hang_arm(side, 0.01 * breath, 0.05 + 0.006 * breath, puppet);
    puppet.set("ear_2" + side.suffix, turn(kZ, side.sign * 0.02 * sway));
  }
  place_feet(plan, {FootTarget(), FootTarget()}, puppet.posture());
  return puppet.posture();
}

/// The rotation of `joint` relative to its nearest kept ancestor: the product of the rotations
/// between them.
Quaternion reduced_rotation(const BodyPlan& plan, std::span<const std::uint32_t> stands_for,
                            const Posture& posture, std::uint32_t joint) {
  Quaternion rotation = posture.local[joint];
  for (std::uint32_t j = plan.joints[joint].parent; j != kNone && stands_for[j] != j;
       j = plan.joints[j].parent) {
    rotation = posture.local[j] * rotation;
  }
  return rotation;
}

asset::Channel rotation_channel(std::uint32_t node, std::span<const float> times) {
  return {
      node, asset::Path::rotation, asset::Interpolation::linear, {times.begin(), times.end()}, {}};
}

asset::Channel hips_channel(const BodyPlan& plan, std::span<const Posture> postures,
                            std::uint32_t node, std::span<const float> times) {
  asset::Channel channel = {node,
                            asset::Path::translation,
                            asset::Interpolation::linear,
                            {times.begin(), times.end()},
                            {}};
  for (const Posture& posture : postures) {
    const Vec3d place = plan.joints[0].position + posture.hips_offset;
    for (double number : {place.x, place.y, place.z}) {
      channel.values.push_back(static_cast<float>(number));
    }
  }
  return channel;
}

using PostureAt = Posture (*)(const BodyPlan&, double phase);

/// The last key repeats the first, so that the clip is a loop.
asset::Clip make_clip(const std::string& name, const BodyPlan& plan,
                      std::span<const std::uint32_t> stands_for,
                      std::span<const std::uint32_t> nodes, PostureAt posture_at, double seconds,
                      int keys) {
  std::vector<float> times;
  std::vector<Posture> postures;
  for (int k = 0; k <= keys; ++k) {
    times.push_back(static_cast<float>(seconds * k / keys));
    postures.push_back(posture_at(plan, (k % keys) / static_cast<double>(keys)));
  }
  asset::Clip clip = {name, times.back(), {hips_channel(plan, postures, nodes[0], times)}};
  for (std::uint32_t j = 0; j < stands_for.size(); ++j) {
    if (stands_for[j] != j) continue;
    asset::Channel channel = rotation_channel(nodes[j], times);
    for (const Posture& posture : postures) {
      const Quaternion q = reduced_rotation(plan, stands_for, posture, j);
      for (double number : {q.x, q.y, q.z, q.w}) {
        channel.values.push_back(static_cast<float>(number));
      }
    }
    clip.channels.push_back(std::move(channel));
  }
  return clip;
}

}  // namespace

asset::Clip walk_clip(const BodyPlan& plan, std::span<const std::uint32_t> stands_for,
                      std::span<const std::uint32_t> nodes) {
  return make_clip("walk", plan, stands_for, nodes, walk_posture, walk_seconds(plan), kWalkKeys);
}

asset::Clip idle_clip(const BodyPlan& plan, std::span<const std::uint32_t> stands_for,
                      std::span<const std::uint32_t> nodes) {
  return make_clip("idle", plan, stands_for, nodes, idle_posture, kIdleSeconds, kIdleKeys);
}

}  // namespace pelt::scenes

#include "scenes/creature/posture.hpp"

#include <algorithm>

namespace pelt::scenes {
namespace {

/// Columns of an orthonormal frame.
struct Frame {
  Vec3d x, y, z;
};

/// x along `direction`, y as close to `pole` as possible.
Frame frame_along(const Vec3d& direction, const Vec3d& pole) {
  const Vec3d x = unit(direction);
  const Vec3d y = unit(pole - dot(pole, x) * x);
  return {x, y, cross(x, y)};
}

/// Not for frames that differ by half a turn; legs never rotate that far.
Quaternion rotation_between(const Frame& from, const Frame& to) {
  const auto element = [&](auto row, auto column) {
    return row(to.x) * column(from.x) + row(to.y) * column(from.y) + row(to.z) * column(from.z);
  };
  const auto x = [](const Vec3d& v) { return v.x; };
  const auto y = [](const Vec3d& v) { return v.y; };
  const auto z = [](const Vec3d& v) { return v.z; };
  const double trace = element(x, x) + element(y, y) + element(z, z);
  return asset::normalised({element(z, y) - element(y, z), element(x, z) - element(z, x),
                            element(y, x) - element(x, y), 1 + trace});
}

Quaternion about_x(double turns) {
  return {asset::sine_of_turns(turns / 2), 0, 0, asset::cosine_of_turns(turns / 2)};
}

struct Leg {
  std::uint32_t thigh, shin, foot, toes;
};

Leg find_leg(const BodyPlan& plan, const std::string& side) {
  return {find_joint(plan, "thigh" + side), find_joint(plan, "shin" + side),
          find_joint(plan, "foot" + side), find_joint(plan, "toes" + side)};
}

/// The position of the ankle after the foot has rotated about its ball, which the flat toes fix, or
/// about the end of its heel on the ground.
Vec3d ankle_place(const BodyPlan& plan, const Leg& leg, const FootTarget& target) {
  const Vec3d ankle = plan.joints[leg.foot].position;
  const Vec3d ball = plan.joints[leg.toes].position;
  const Vec3d heel(ankle.x, 0, ankle.z - 0.55 * (ball.z - ankle.z));
  const Vec3d pivot = target.pitch > 0 ? ball : heel;
  return pivot + rotate(about_x(target.pitch), ankle - pivot) + target.offset;
}

/// The third vertex of a triangle over `from` - `to` with sides `near` and `far`, towards `pole`.
Vec3d bend(const Vec3d& from, const Vec3d& to, double near, double far, const Vec3d& pole) {
  const double distance = std::min(length(to - from), 0.9995 * (near + far));
  const double along = (near * near - far * far + distance * distance) / (2 * distance);
  const double aside = std::sqrt(std::max(0.0, near * near - along * along));
  const Frame frame = frame_along(to - from, pole);
  return from + along * frame.x + aside * frame.y;
}

void place_foot(const BodyPlan& plan, const Leg& leg, const FootTarget& target, Posture& posture) {
  const Quaternion hips = posture.local[0];
  const Vec3d hips_rest = plan.joints[0].position;
  const Vec3d thigh_rest = plan.joints[leg.thigh].position;
  const Vec3d knee_rest = plan.joints[leg.shin].position;
  const Vec3d ankle_rest = plan.joints[leg.foot].position;
  const Vec3d forwards(0, 0, 1);

  const Vec3d hip = hips_rest + posture.hips_offset + rotate(hips, thigh_rest - hips_rest);
  const Vec3d ankle = ankle_place(plan, leg, target);
  const Vec3d knee =
      bend(hip, ankle, length(knee_rest - thigh_rest), length(ankle_rest - knee_rest), forwards);
  const Quaternion thigh = rotation_between(frame_along(knee_rest - thigh_rest, forwards),
                                            frame_along(knee - hip, forwards));
  const Quaternion shin = rotation_between(frame_along(ankle_rest - knee_rest, forwards),
                                           frame_along(ankle - knee, forwards));
  const Quaternion foot = about_x(target.pitch);
  posture.local[leg.thigh] = conjugate(hips) * thigh;
  posture.local[leg.shin] = conjugate(thigh) * shin;
  posture.local[leg.foot] = conjugate(shin) * foot;
  posture.local[leg.toes] = about_x(-target.toe_bend);
}

}  // namespace

void place_feet(const BodyPlan& plan, const std::array<FootTarget, 2>& targets, Posture& posture) {
  place_foot(plan, find_leg(plan, "_l"), targets[0], posture);
  place_foot(plan, find_leg(plan, "_r"), targets[1], posture);
}

}  // namespace pelt::scenes

#include "scenes/creature/expressions.hpp"

#include "asset/transform.hpp"

#include <algorithm>
#include <limits>

namespace pelt::scenes {
namespace {

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

}  // namespace pelt::scenes

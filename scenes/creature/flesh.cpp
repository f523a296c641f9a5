#include "scenes/creature/flesh.hpp"

#include "base/assert.hpp"

#include <algorithm>
#include <limits>

namespace pelt::scenes {
namespace {

constexpr double kSoleBlend = 0.02;
constexpr int kProjectionSteps = 3;
constexpr double kOnSurface = 1e-8;

// The nearest ball of the cone: the minimum over t of |p - c(t)| - r(t), a convex function. With u
// along the axis and v across it, the derivative vanishes where (u - t l) / |p - c(t)| = (r_a -
// r_b) / l, the sine of the cone's slope.
double nearest_ball(const RoundCone& cone, const Vec3d& point) {
  const Vec3d axis = cone.b - cone.a;
  const double l2 = squared_length(axis);
  if (l2 == 0) return 0;
  const Vec3d from_a = point - cone.a;
  const double along = dot(from_a, axis);
  const double across = std::sqrt(std::max(0.0, squared_length(from_a) * l2 - along * along));
  const double taper = cone.radius_a - cone.radius_b;
  PELT_ASSERT(taper * taper < l2);
  const double t = (along - across * taper / std::sqrt(l2 - taper * taper)) / l2;
  return std::clamp(t, 0.0, 1.0);
}

FleshSample sample_cone(const RoundCone& cone, const Vec3d& point) {
  const double t = nearest_ball(cone, point);
  const double radius = cone.radius_a + t * (cone.radius_b - cone.radius_a);
  const Vec3d way = point - mix(cone.a, cone.b, t);
  const double from_centre = length(way);
  // At the centre of a ball every direction is downhill; no caller needs the gradient there.
  const Vec3d gradient = from_centre > 0 ? (1 / from_centre) * way : Vec3d(0, 1, 0);
  return {from_centre - radius, gradient, radius};
}

// The smaller of two distances, with a fillet if they differ by less than `blend`. Cubic, so that
// the surface has continuous curvature; a convex combination of gradients, so that none becomes
// longer than 1.
FleshSample smooth_union(const FleshSample& a, const FleshSample& b, double blend) {
  const FleshSample& near = a.distance <= b.distance ? a : b;
  const FleshSample& far = a.distance <= b.distance ? b : a;
  const double overlap = (blend - (far.distance - near.distance)) / blend;
  if (!(overlap > 0)) return near;
  const double share = overlap * overlap / 2;
  return {near.distance - overlap * overlap * overlap * blend / 6,
          mix(near.gradient, far.gradient, share),
          near.thickness + share * (far.thickness - near.thickness)};
}

FleshSample negated(const FleshSample& s) { return {-s.distance, -1.0 * s.gradient, s.thickness}; }

FleshSample cut_at_sole(const FleshSample& body, const Vec3d& point) {
  const FleshSample above_ground = {point.y, Vec3d(0, 1, 0), body.thickness};
  return negated(smooth_union(negated(body), above_ground, kSoleBlend));
}

const FleshSample kNothing = {std::numeric_limits<double>::infinity(), {}, 0};

bool is_within(double reach, const Ball& ball, const Vec3d& point) {
  const double sum = reach + ball.radius;
  return sum > 0 && squared_length(point - ball.centre) < sum * sum;
}

FleshSample sample_limb(const Limb& limb, const Vec3d& point, double reach) {
  FleshSample sum = kNothing;
  for (const Muscle& muscle : limb.muscles) {
    if (!is_within(reach, muscle.bound, point)) continue;
    sum = smooth_union(sum, sample_cone(muscle.shape, point), muscle.blend);
  }
  return sum;
}

/// The element with the nearest bound, approximately.
template <typename Bounded>
const Bounded& likely_nearest(const std::vector<Bounded>& candidates, const Vec3d& point) {
  const Bounded* nearest = &candidates.front();
  double least = std::numeric_limits<double>::infinity();
  for (const Bounded& candidate : candidates) {
    const Ball& ball = candidate.bound;
    const double power = squared_length(point - ball.centre) - ball.radius * ball.radius;
    if (power < least) nearest = &candidate;
    least = std::min(least, power);
  }
  return *nearest;
}

Ball ball_around(const RoundCone& cone) {
  const double half = length(cone.b - cone.a) / 2;
  return {mix(cone.a, cone.b, 0.5), half + std::max(cone.radius_a, cone.radius_b)};
}

Ball ball_around(const std::vector<Muscle>& muscles) {
  Vec3d sum;
  for (const Muscle& muscle : muscles) sum = sum + muscle.bound.centre;
  Ball ball = {(1.0 / static_cast<double>(muscles.size())) * sum, 0};
  for (const Muscle& muscle : muscles) {
    const double far = length(muscle.bound.centre - ball.centre) + muscle.bound.radius;
    ball.radius = std::max(ball.radius, far);
  }
  return ball;
}

}  // namespace

void compute_bounds(Flesh& flesh) {
  for (Limb& limb : flesh.limbs) {
    PELT_ASSERT(limb.blend <= kLargestBlend);
    for (Muscle& muscle : limb.muscles) {
      PELT_ASSERT(muscle.blend <= kLargestBlend);
      muscle.bound = ball_around(muscle.shape);
    }
    limb.bound = ball_around(limb.muscles);
  }
}

// Any muscle, here probably the closest, gives an upper bound of the distance. Muscles that are
// farther than this by more than the widest fillet have no influence.
FleshSample sample_flesh(const Flesh& flesh, const Vec3d& point) {
  const Limb& limb_near = likely_nearest(flesh.limbs, point);
  const Muscle& muscle_near = likely_nearest(limb_near.muscles, point);
  const double reach = muscle_distance(muscle_near, point) + 1.01 * kLargestBlend;
  FleshSample body = kNothing;
  for (const Limb& limb : flesh.limbs) {
    if (!is_within(reach, limb.bound, point)) continue;
    const FleshSample sample = sample_limb(limb, point, reach);
    if (sample.distance < reach) body = smooth_union(body, sample, limb.blend);
  }
  return cut_at_sole(body, point);
}

double muscle_distance(const Muscle& muscle, const Vec3d& point) {
  return sample_cone(muscle.shape, point).distance;
}

FleshSample project_on_flesh(const Flesh& flesh, Vec3d& point) {
  FleshSample here = sample_flesh(flesh, point);
  for (int step = 0; step < kProjectionSteps && std::abs(here.distance) > kOnSurface; ++step) {
    const double slope2 = std::max(0.1, squared_length(here.gradient));
    point = point - (here.distance / slope2) * here.gradient;
    here = sample_flesh(flesh, point);
  }
  return here;
}

}  // namespace pelt::scenes

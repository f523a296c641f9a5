#pragma once

#include "scenes/creature/vector.hpp"

#include <cstdint>
#include <vector>

namespace pelt::scenes {

/// The union of the balls whose centres run from `a` to `b` while their radii run from `radius_a`
/// to `radius_b`. The radii differ by less than the length, or both ends are the same ball.
struct RoundCone {
  Vec3d a;
  double radius_a = 0;
  Vec3d b;
  double radius_b = 0;
};

struct Ball {
  Vec3d centre;
  double radius = 0;
};

/// A round cone that moves with a joint.
struct Muscle {
  std::uint32_t joint = 0;
  RoundCone shape;
  double blend = 0;  ///< width of the fillet between it and the muscles before it in its limb
  Ball bound;        ///< around the shape
};

/// Muscles that blend with one another first, then as a whole with the limbs before it: so fingers
/// blend with their palm, not with each other.
struct Limb {
  std::vector<Muscle> muscles;
  double blend = 0;
  Ball bound;  ///< around the muscles
};

/// No `blend` is wider.
inline constexpr double kLargestBlend = 0.12;

/// The creature's body as an implicit surface. Its sole is flat: the body ends at y = 0.
struct Flesh {
  std::vector<Limb> limbs;
};

/// Fills in all bounds, from the shapes.
void compute_bounds(Flesh& flesh);

/// The implicit surface at a point: distance (a lower bound of it, negative inside), its gradient,
/// and how thick the body is thereabouts. Distance, gradient and thickness are smooth.
struct FleshSample {
  double distance = 0;
  Vec3d gradient;
  double thickness = 0;
};

/// The distance changes by at most 1 per unit of way.
FleshSample sample_flesh(const Flesh& flesh, const Vec3d& point);

/// Distance to one muscle alone.
double muscle_distance(const Muscle& muscle, const Vec3d& point);

/// Moves `point` along the gradient onto the surface and returns the sample there.
FleshSample project_on_flesh(const Flesh& flesh, Vec3d& point);

}  // namespace pelt::scenes

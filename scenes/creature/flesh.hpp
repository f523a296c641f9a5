#pragma once

#include "base/vec3.hpp"

#include <cmath>
#include <cstdint>
#include <vector>

namespace pelt::scenes {

using detail::cross;
using detail::dot;
using detail::squared_length;
using detail::Vec3d;

inline double length(const Vec3d& v) { return std::sqrt(squared_length(v)); }

/// Precondition: `v` is not 0.
inline Vec3d unit(const Vec3d& v) { return (1 / length(v)) * v; }

inline Vec3d mix(const Vec3d& a, const Vec3d& b, double t) { return a + t * (b - a); }

/// The union of balls whose centres move from `a` to `b` while their radii change from `radius_a`
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

/// A round cone that follows a joint.
struct Muscle {
  std::uint32_t joint = 0;
  RoundCone shape;
  double blend = 0;  ///< width of the fillet between it and the muscles before it in its limb
  Ball bound;        ///< around the shape
};

/// Muscles that blend with one another first, then together with the limbs before them. Fingers
/// therefore blend with their palm, not with each other.
struct Limb {
  std::vector<Muscle> muscles;
  double blend = 0;
  Ball bound;  ///< around the muscles
};

/// The largest `blend`.
inline constexpr double kLargestBlend = 0.12;

/// The creature's body as an implicit surface. Its sole is flat: the body ends at y = 0.
struct Flesh {
  std::vector<Limb> limbs;
};

/// Computes all bounds from the shapes.
void compute_bounds(Flesh& flesh);

/// The implicit surface at a point: a lower bound of the distance (negative inside), its gradient,
/// and the thickness of the body there. All are smooth.
struct FleshSample {
  double distance = 0;
  Vec3d gradient;
  double thickness = 0;
};

/// The distance changes by at most 1 per unit of length.
FleshSample sample_flesh(const Flesh& flesh, const Vec3d& point);

/// Distance to a single muscle.
double muscle_distance(const Muscle& muscle, const Vec3d& point);

/// Moves `point` along the gradient onto the surface and returns the sample there.
FleshSample project_on_flesh(const Flesh& flesh, Vec3d& point);

}  // namespace pelt::scenes

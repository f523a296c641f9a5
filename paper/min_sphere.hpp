#pragma once

#include "paper/sphere.hpp"

#include <span>

namespace pelt::paper {

/// The minimal enclosing sphere of points, for the sphere tree of the rest pose (Kavan & Zara 2005,
/// section 3.1). Encloses the points exactly: the radius is measured from the rounded centre to the
/// farthest point and rounded up. Deterministic. Costs about ten passes over the points.
/// Precondition: `points` is not empty, and coordinates are at most 2^60.
Sphere min_sphere(std::span<const Vec3> points);

}  // namespace pelt::paper

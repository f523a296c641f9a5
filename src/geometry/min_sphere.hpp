#pragma once

#include "geometry/sphere.hpp"
#include "geometry/triangle_pair.hpp"

#include <span>

namespace pelt::detail {

/// Minimal enclosing spheres. Each returned float sphere encloses its points exactly: whatever
/// rounding did to the centre, the radius is measured from the rounded centre to the farthest point
/// and rounded up. Precondition of both: coordinates of at most 2^60.

/// The minimal enclosing sphere of points, for the rest pose's sphere tree (Kavan & Zara 2005,
/// section 3.1). Deterministic; about ten passes over the points. Precondition: `points` is not
/// empty.
Sphere min_sphere(std::span<const Vec3> points);

/// The same of a triangle's corners, in closed form: for every leaf of an eager refit.
Sphere ball_of_triangle(const TriangleCorners& corners);

}  // namespace pelt::detail

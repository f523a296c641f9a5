#pragma once

#include "geometry/sphere.hpp"

#include <span>
#include <vector>

namespace pelt::detail {

/// The minimal enclosing sphere of points, for the rest pose's sphere tree (Kavan & Zara 2005,
/// section 3.1; Gaertner, "Fast and robust smallest enclosing balls", ESA 1999: move-to-front with
/// pivoting on the farthest point, in double).
///
/// The returned float sphere encloses every point exactly: whatever rounding did, the radius is
/// measured from the rounded centre to the farthest point and rounded up. Reorders `points`.
/// Expected O(n). Precondition: `points` is not empty and finite.
Sphere min_sphere(std::span<Vec3> points);

}  // namespace pelt::detail

#pragma once

/// Exact tests of a triangle against a convex polyhedron, given by its faces, and a capsule.

#include <pelt/math.hpp>

#include "geometry/triangle_pair.hpp"

#include <span>

namespace pelt::detail {

/// All points p with normal . (p - origin) <= offset.
struct Face {
  Vec3 normal, origin;
  float offset = 0;
};

enum class TrianglePlace { apart, touching, inside };

/// Returns where a closed triangle lies with respect to the intersection of half-spaces. `touching`
/// means touching but not inside. Precondition: all numbers are finite, and there are at most
/// kMaxFaces faces.
TrianglePlace place_triangle(const TriangleCorners& triangle, std::span<const Face> faces);

/// Returns exactly where a closed triangle lies with respect to a capsule. A sphere is a capsule
/// with equal ends. Precondition: all numbers are finite, and the radius is not negative.
TrianglePlace place_triangle(const TriangleCorners& triangle, const Capsule& capsule);

}  // namespace pelt::detail

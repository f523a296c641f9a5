#pragma once

/// A triangle against a convex polyhedron that is given by its faces, exactly.

#include <pelt/shapes.hpp>

#include "geometry/triangle_pair.hpp"

#include <span>

namespace pelt::detail {

/// All points p with normal . (p - origin) <= offset.
struct Face {
  Vec3 normal, origin;
  float offset = 0;
};

enum class TrianglePlace { apart, touching, inside };

/// Where a closed triangle lies with respect to what all these half-spaces have in common:
/// `touching` is short of `inside`. Precondition: finite, and no more than kMaxFaces of them.
TrianglePlace place_triangle(const TriangleCorners& triangle, std::span<const Face> faces);

}  // namespace pelt::detail

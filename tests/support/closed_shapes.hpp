#pragma once

/// Closed surfaces that do not deform.

#include "support/skinned_shapes.hpp"

namespace pelt::test {

/// A shape with a single joint.
Shape make_rigid(const std::vector<Vec3>& positions, const std::vector<Triangle>& triangles);

/// An axis-aligned cube. Four triangles per side, around its middle.
Shape make_cube(float half, const Vec3& centre);

/// A sphere around the origin: an octahedron whose triangles are cut into four `cuts` times.
Shape make_sphere(float radius, int cuts);

/// Both shapes in one mesh.
Shape together(const Shape& a, const Shape& b);

/// Each triangle cut into four; no two triangles share a vertex index.
Shape cut(const Shape& shape);

}  // namespace pelt::test

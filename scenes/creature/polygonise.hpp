#pragma once

#include <pelt/mesh.hpp>

#include "scenes/creature/flesh.hpp"

#include <vector>

namespace pelt::scenes {

struct RawMesh {
  std::vector<Vec3d> positions;
  std::vector<Triangle> triangles;  ///< counter-clockwise seen from outside
};

/// The surface as a closed, orientable 2-manifold, by marching tetrahedra on a cubic lattice of
/// `spacing`. Each tetrahedron is cut in a unique way, and neighbours agree on their common face.
/// Triangles are small, numerous and badly shaped. O(area / spacing^2).
RawMesh polygonise(const Flesh& flesh, double spacing);

}  // namespace pelt::scenes

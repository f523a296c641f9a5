#pragma once

#include <pelt/math.hpp>
#include <pelt/mesh.hpp>

namespace pelt::rivals {

/// A body as it stands: plain pointers, for the code that is compiled for each target.
struct PosedMesh {
  const Triangle* triangles = nullptr;
  const Vec3* positions = nullptr;
};

}  // namespace pelt::rivals

#pragma once

#include <pelt/math.hpp>
#include <pelt/mesh.hpp>

namespace pelt::rivals {

/// A posed body as plain pointers, for code that is compiled for each instruction set.
struct PosedMesh {
  const Triangle* triangles = nullptr;
  const Vec3* positions = nullptr;
};

}  // namespace pelt::rivals

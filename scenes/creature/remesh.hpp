#pragma once

#include "scenes/creature/polygonise.hpp"

#include <cstdint>

namespace pelt::scenes {

/// Turns the polygonised surface into one of exactly `triangle_count` well-shaped triangles, which
/// are small where the body is thin. Works in stages: collapses edges, shortest first, then flips
/// edges and evens out vertices along the surface. The result is a closed 2-manifold of the same
/// genus as `raw`. Precondition: `triangle_count` is even and at most that of `raw`.
RawMesh remesh(const Flesh& flesh, RawMesh raw, std::uint32_t triangle_count);

}  // namespace pelt::scenes

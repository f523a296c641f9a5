#pragma once

#include "scenes/creature/polygonise.hpp"

#include <cstdint>

namespace pelt::scenes {

/// Turns the polygonised surface into one of exactly `triangle_count` well-shaped triangles, small
/// where the body is thin: collapses edges, shortest first, then flips edges and evens out vertices
/// along the surface, in stages. The result is a closed 2-manifold of the same genus as `raw`.
/// Preconditions: `triangle_count` is even and not above that of `raw`.
RawMesh remesh(const Flesh& flesh, RawMesh raw, std::uint32_t triangle_count);

}  // namespace pelt::scenes

#pragma once

/// What does not change between poses of a closed surface, and tells how winding numbers spread
/// over it. Just in front of the surface, the winding number changes only where the surface crosses
/// itself. It is therefore the same on both sides of an edge, at each point of the edge.

#include "model/surface.hpp"
#include "self/self_filter.hpp"

#include <cstdint>
#include <vector>

namespace pelt::detail {

/// Triangles, by their places, that share an edge. Edge `edge` of `triangle`, reversed, is edge
/// `edge_from` of `from`. If both are the same triangle, a connected part of the surface begins.
struct SpreadingStep {
  std::uint32_t triangle, from;
  std::uint8_t edge = 0, edge_from = 0;

  bool is_first() const { return triangle == from; }
};

static_assert(sizeof(SpreadingStep) == 12, "stated in pelt/volume.hpp, with those of the filter");

struct SurfaceLinks {
  /// Precondition: the surface is closed.
  explicit SurfaceLinks(const Surface& surface);

  SelfFilter neighbours;             ///< leaves out nothing
  std::vector<SpreadingStep> steps;  ///< one for each triangle without repeated vertices
};

/// Returns the links of a surface. The first call makes them. Can be called from several threads at
/// once. Precondition: the surface is closed.
const SurfaceLinks& links_of(const Surface& surface);

}  // namespace pelt::detail

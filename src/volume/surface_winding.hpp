#pragma once

/// The order in which winding numbers spread over a closed surface, from triangle to triangle. It
/// is the same in all poses. Just in front of the surface, the winding number changes only where
/// the surface crosses itself. It is therefore the same on both sides of an edge, at each point of
/// the edge.

#include <pelt/mesh.hpp>

#include "geometry/triangle_pair.hpp"
#include "model/surface.hpp"
#include "pose/posed_tree.hpp"
#include "query/scratch.hpp"
#include "self/self_filter.hpp"
#include "volume/perturbed_points.hpp"

#include <cstdint>
#include <vector>

namespace pelt::detail {

inline NumberedTriangle numbered(const TriangleCorners& corners, const Triangle& numbers) {
  return {{{corners[0], numbers[0]}, {corners[1], numbers[1]}, {corners[2], numbers[2]}}};
}

/// Returns the winding number of a surface just in front of one of its triangles, at the start of
/// edge 0, as if its vertices were in general position (volume/perturbed_points.hpp). Exact.
///
/// `place`: of a triangle without repeated vertices.
/// `nodes`: working memory.
///
/// Cost: that of a ray. Preconditions: the surface is closed, and all nodes are open.
int front_winding(const PosedTree& posed, const Surface& surface, std::uint32_t place,
                  Stack<std::uint32_t>& nodes, QueryStats& work);

/// Triangles, by their places, that share an edge. Edge `edge` of `triangle`, reversed, is edge
/// `edge_from` of `from`. If both are the same triangle, a connected part of the surface begins.
struct SpreadingStep {
  std::uint32_t triangle, from;
  std::uint8_t edge = 0, edge_from = 0;

  bool is_first() const { return triangle == from; }
};

static_assert(sizeof(SpreadingStep) == 12, "stated in pelt/inside.hpp, with those of the filter");

struct WindingSpread {
  /// Precondition: the surface is closed.
  explicit WindingSpread(const Surface& surface);

  SelfFilter neighbours;             ///< leaves out nothing
  std::vector<SpreadingStep> steps;  ///< one for each triangle without repeated vertices
};

/// Returns the spread of a surface. The first call makes it. Can be called from several threads at
/// once. Precondition: the surface is closed.
const WindingSpread& spread_of(const Surface& surface);

}  // namespace pelt::detail

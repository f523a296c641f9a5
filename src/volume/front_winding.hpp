#pragma once

#include "model/surface.hpp"
#include "pose/posed_tree.hpp"
#include "query/scratch.hpp"

#include <cstdint>

namespace pelt::detail {

/// Returns the winding number of a surface just in front of one of its triangles, at the start of
/// edge 0, as if its vertices were in general position (geometry/perturbed_points.hpp). Exact.
///
/// `place`: of a triangle without repeated vertices.
/// `nodes`: working memory.
///
/// Cost: that of a ray. Preconditions: the surface is closed, and all nodes are open.
int front_winding(const PosedTree& posed, const Surface& surface, std::uint32_t place,
                  Stack<std::uint32_t>& nodes, QueryStats& work);

}  // namespace pelt::detail

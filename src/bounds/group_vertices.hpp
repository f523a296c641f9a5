#pragma once

#include "model/tree.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace pelt::detail {

/// Sets of vertices, each a list of places in the tree's pools, ascending.
using VertexSets = std::vector<std::vector<std::uint32_t>>;

/// Returns the vertices of the triangles with each label, ignoring kNoGroup. Precondition: `labels`
/// has one element per triangle, each less than `count` or kNoGroup.
VertexSets corners_by_label(const Tree& tree, std::span<const std::uint32_t> labels,
                            std::uint32_t count);

/// Returns the vertices of all triangles by the joint with their largest weight; of equal weights,
/// the first.
VertexSets corners_by_joint(const Tree& tree);

}  // namespace pelt::detail

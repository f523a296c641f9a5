#pragma once

#include "model/tree.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace pelt::detail {

/// Sets of vertices, each a list of places in the tree's pools, ascending.
using VertexSets = std::vector<std::vector<std::uint32_t>>;

/// The corners of the triangles with each label; kNoGroup is none. Precondition: `labels` has one
/// for each triangle, each less than `count` or kNoGroup.
VertexSets corners_by_label(const Tree& tree, std::span<const std::uint32_t> labels,
                            std::uint32_t count);

/// The corners of all triangles by the joint that has their largest weight, of equals the first.
VertexSets corners_by_joint(const Tree& tree);

}  // namespace pelt::detail

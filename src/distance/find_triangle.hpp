#pragma once

#include "geometry/triangle_pair.hpp"
#include "pose/posed_tree.hpp"

#include <cstdint>

namespace pelt::detail {

/// Where a triangle is in an opened tree.
struct FoundTriangle {
  TriangleCorners corners;
  std::uint32_t node, slot;  ///< its cluster
};

/// The triangle with the caller's number `id`, O(T); its node is opened if it was not.
/// Preconditions: there is one, and a table of opened nodes.
FoundTriangle find_triangle(const PosedTree& posed, std::uint32_t id);

}  // namespace pelt::detail
